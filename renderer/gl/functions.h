// The OpenGL 4.5 functions that Pelage uses, loaded through the context (never linked: see docs/headless-gl.md).
#pragma once

#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES  // for their types
#endif
#include <GL/glcorearb.h>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>

// Functions of the GL by their names, without "gl": those that are called as they are, and those that Gl counts.
// clang-format off
#define PELAGE_GL_CALLS(X) \
  X(AttachShader) X(BeginQuery) X(BindBufferBase) X(BindFramebuffer) X(BindVertexArray) X(BlendEquation) \
  X(BlendFunc) X(CheckNamedFramebufferStatus) X(ClearNamedBufferData) X(ClearNamedFramebufferfv) \
  X(ClientWaitSync) X(ClipControl) X(ColorMask) X(CompileShader) X(CopyTextureSubImage3D) X(CreateBuffers) \
  X(CreateFramebuffers) X(CreateProgram) X(CreateQueries) X(CreateRenderbuffers) X(CreateShader) \
  X(CreateTextures) X(CreateVertexArrays) X(DeleteFramebuffers) X(DeleteProgram) X(DeleteQueries) \
  X(DeleteShader) X(DeleteSync) X(DeleteVertexArrays) X(DepthFunc) X(DepthMask) X(Disable) X(Enable) \
  X(EnableVertexArrayAttrib) X(EndQuery) X(FenceSync) X(Finish) X(Flush) X(GenerateTextureMipmap) X(GetError) \
  X(GetIntegerv) X(GetNamedBufferSubData) X(GetProgramInfoLog) X(GetProgramiv) X(GetQueryObjectui64v) \
  X(GetShaderInfoLog) X(GetShaderiv) X(GetString) X(GetUniformLocation) X(LinkProgram) X(MemoryBarrier) \
  X(NamedFramebufferRenderbuffer) X(NamedFramebufferTexture) X(PixelStorei) X(ReadPixels) X(Scissor) \
  X(ShaderSource) X(TextureParameteri) X(Uniform1f) X(Uniform1i) X(Uniform3f) X(UniformMatrix4fv) \
  X(VertexArrayAttribBinding) X(VertexArrayAttribFormat) X(VertexArrayElementBuffer) X(VertexArrayVertexBuffer) \
  X(Viewport)
#define PELAGE_GL_COUNTED_CALLS(X) \
  X(BindTextureUnit) X(DeleteBuffers) X(DeleteRenderbuffers) X(DeleteTextures) X(DrawArrays) X(DrawElements) \
  X(DrawElementsInstanced) X(NamedBufferData) X(NamedBufferSubData) X(NamedRenderbufferStorage) \
  X(TextureStorage2D) X(TextureStorage3D) X(TextureSubImage2D) X(TextureSubImage3D) X(UseProgram)
// clang-format on

namespace pelage {

/// Looks a function up by name; null where the context has none.
using LoadFunction = std::function<void*(const char*)>;

/// What was asked of the GL; bytes are those of buffers and textures that came from the CPU, `allocated` those of the
/// storage that was asked for, and objects those that were made.
struct GlCounts {
  std::size_t programs = 0, draws = 0, textures = 0, bytes = 0, allocated = 0, objects = 0;
};

/// A table of functions, valid for one context on one thread. Calls that frames are measured by are counted.
struct Gl {
#define PELAGE_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
  PELAGE_GL_CALLS(PELAGE_GL_MEMBER)

  void BindTextureUnit(GLuint unit, GLuint texture) const;
  void DeleteBuffers(GLsizei count, const GLuint* buffers) const;
  void DeleteRenderbuffers(GLsizei count, const GLuint* buffers) const;
  void DeleteTextures(GLsizei count, const GLuint* textures) const;
  void DrawArrays(GLenum mode, GLint first, GLsizei count) const;
  void DrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) const;
  void DrawElementsInstanced(GLenum mode, GLsizei count, GLenum type, const void* indices, GLsizei instances) const;
  void NamedBufferData(GLuint buffer, GLsizeiptr size, const void* data, GLenum usage) const;
  void NamedRenderbufferStorage(GLuint buffer, GLenum format, GLsizei width, GLsizei height) const;
  void NamedBufferSubData(GLuint buffer, GLintptr offset, GLsizeiptr size, const void* data) const;
  void TextureStorage2D(GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height) const;
  void TextureStorage3D(GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height,
                        GLsizei depth) const;
  /// Of 1, 2 or 4 channels (GL_RED, GL_RG, GL_RGBA) in bytes or floats.
  void TextureSubImage2D(GLuint texture, GLint level, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                         GLenum type, const void* pixels) const;
  void TextureSubImage3D(GLuint texture, GLint level, GLint x, GLint y, GLint z, GLsizei width, GLsizei height,
                         GLsizei depth, GLenum format, GLenum type, const void* pixels) const;
  void UseProgram(GLuint program) const;

  /// Called by all that make an object (handles.h).
  void count_object() const { ++counts_.objects; }
  /// What was counted since the last call.
  GlCounts take_counts() const { return std::exchange(counts_, {}); }

  /// Bytes of storage that buffers, textures and renderbuffers have now; of one of them, 0 where it has none.
  std::size_t held_bytes() const { return held_bytes_; }
  std::size_t bytes_of_buffer(GLuint buffer) const { return bytes_of({Kind::buffer, buffer}); }
  std::size_t bytes_of_texture(GLuint texture) const { return bytes_of({Kind::texture, texture}); }

  /// Loads every function. Returns the first name that the context lacks, or "".
  std::string load(const LoadFunction& find);

 private:
  struct Counted {
    PELAGE_GL_COUNTED_CALLS(PELAGE_GL_MEMBER)
#undef PELAGE_GL_MEMBER
  };
  enum class Kind { buffer, texture, renderbuffer };  // whose names are told apart
  using Name = std::pair<Kind, GLuint>;

  std::size_t bytes_of(Name name) const;
  void note_storage(Name name, std::size_t bytes) const;
  void forget_storage(Kind kind, GLsizei count, const GLuint* names) const;

  Counted counted_;
  // Counting changes nothing that a user of the table sees.
  mutable GlCounts counts_;
  mutable std::map<Name, std::size_t> held_;  // bytes of storage
  mutable std::size_t held_bytes_ = 0;
};

}  // namespace pelage
