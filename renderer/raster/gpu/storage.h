// Storage buffers on the GPU, which stages read and write.
#pragma once

#include <cstddef>
#include <span>

#include "renderer/gl/handles.h"

namespace pelage {

inline constexpr std::size_t word_bytes = 4;

/// A storage buffer that only grows.
class Storage {
 public:
  explicit Storage(const Gl& gl) : gl_(&gl), buffer_(gl) {
    reserve(min_bytes);
  }  // never empty, so that it can be bound

  GLuint id() const { return buffer_.id(); }
  std::size_t bytes() const { return bytes_; }

  /// Makes room for at least so many bytes. The contents are lost if the buffer grows.
  void reserve(std::size_t bytes) {
    if (bytes <= bytes_) return;
    bytes_ = bytes;
    gl_->NamedBufferData(buffer_.id(), static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_DRAW);
  }
  /// Writes these values from the start on; the rest keeps its contents unless the buffer grows.
  template <class T>
  void send(std::span<const T> values) {
    reserve(values.size_bytes());
    send_at(0, values);
  }
  template <class T>
  void send_at(std::size_t byte, std::span<const T> values) {
    if (!values.empty())
      gl_->NamedBufferSubData(buffer_.id(), static_cast<GLintptr>(byte), static_cast<GLsizeiptr>(values.size_bytes()),
                              values.data());
  }
  void clear(GLuint value) {
    gl_->ClearNamedBufferData(buffer_.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &value);
  }
  template <class T>
  void read(std::size_t byte, std::span<T> values) const {
    gl_->GetNamedBufferSubData(buffer_.id(), static_cast<GLintptr>(byte), static_cast<GLsizeiptr>(values.size_bytes()),
                               values.data());
  }

 private:
  static constexpr std::size_t min_bytes = 16;

  const Gl* gl_;
  Buffer buffer_;
  std::size_t bytes_ = 0;
};

}  // namespace pelage
