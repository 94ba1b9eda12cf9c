#include "renderer/gl/functions.h"

#include <algorithm>
#include <string_view>

namespace pelage {

namespace {

std::size_t texel_bytes(GLenum format, GLenum type) {
  const std::size_t channels = format == GL_RGBA ? 4 : format == GL_RG ? 2 : 1;
  return channels * (type == GL_FLOAT ? sizeof(GLfloat) : sizeof(GLubyte));
}

std::size_t stored_bytes(GLenum format) {
  switch (format) {
    case GL_R16F: return 2;
    case GL_RGBA16:
    case GL_RGBA16F:
    case GL_RG32F: return 8;
    case GL_RGBA32F: return 16;
    default: return 4;  // GL_RGBA8, GL_SRGB8_ALPHA8, GL_R32F, GL_DEPTH_COMPONENT32F
  }
}

/// Returns the number of texels of one mip level.
std::size_t volume(GLsizei width, GLsizei height, GLsizei depth) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(depth);
}

/// Returns the bytes of all mip levels, each half as wide and high as the last. `depth` stays the same, as in arrays.
std::size_t texture_bytes(GLsizei levels, GLenum format, GLsizei width, GLsizei height, GLsizei depth) {
  std::size_t bytes = 0;
  for (GLsizei level = 0; level < levels; ++level) {
    bytes += volume(width, height, depth) * stored_bytes(format);
    width = std::max(1, width / 2), height = std::max(1, height / 2);
  }
  return bytes;
}

}  // namespace

void Gl::note_storage(Name name, std::size_t bytes) const {
  std::size_t& stored = storage_[name];
  storage_bytes_ += bytes - stored;
  stored = bytes;
}

void Gl::forget_storage(Kind kind, GLsizei count, const GLuint* names) const {
  for (GLsizei i = 0; i < count; ++i) {
    const auto found = storage_.find({kind, names[i]});
    if (found == storage_.end()) continue;
    storage_bytes_ -= found->second;
    storage_.erase(found);
  }
}

std::size_t Gl::bytes_of(Name name) const {
  const auto found = storage_.find(name);
  return found == storage_.end() ? 0 : found->second;
}

void Gl::DeleteBuffers(GLsizei count, const GLuint* buffers) const {
  forget_storage(Kind::buffer, count, buffers);
  counted_.DeleteBuffers(count, buffers);
}

void Gl::DeleteRenderbuffers(GLsizei count, const GLuint* buffers) const {
  forget_storage(Kind::renderbuffer, count, buffers);
  counted_.DeleteRenderbuffers(count, buffers);
}

void Gl::DeleteTextures(GLsizei count, const GLuint* textures) const {
  forget_storage(Kind::texture, count, textures);
  counted_.DeleteTextures(count, textures);
}

void Gl::BindTextureUnit(GLuint unit, GLuint texture) const {
  ++counts_.textures;
  counted_.BindTextureUnit(unit, texture);
}

void Gl::DrawArrays(GLenum mode, GLint first, GLsizei count) const {
  ++counts_.draws;
  counted_.DrawArrays(mode, first, count);
}

void Gl::DrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) const {
  ++counts_.draws;
  counted_.DrawElements(mode, count, type, indices);
}

void Gl::DrawElementsInstanced(GLenum mode, GLsizei count, GLenum type, const void* indices, GLsizei instances) const {
  ++counts_.draws;
  counted_.DrawElementsInstanced(mode, count, type, indices, instances);
}

void Gl::NamedBufferData(GLuint buffer, GLsizeiptr size, const void* data, GLenum usage) const {
  if (data) counts_.bytes += static_cast<std::size_t>(size);
  counts_.allocated += static_cast<std::size_t>(size);
  note_storage({Kind::buffer, buffer}, static_cast<std::size_t>(size));
  counted_.NamedBufferData(buffer, size, data, usage);
}

void Gl::NamedBufferSubData(GLuint buffer, GLintptr offset, GLsizeiptr size, const void* data) const {
  counts_.bytes += static_cast<std::size_t>(size);
  counted_.NamedBufferSubData(buffer, offset, size, data);
}

void Gl::NamedRenderbufferStorage(GLuint buffer, GLenum format, GLsizei width, GLsizei height) const {
  counts_.allocated += volume(width, height, 1) * stored_bytes(format);
  note_storage({Kind::renderbuffer, buffer}, volume(width, height, 1) * stored_bytes(format));
  counted_.NamedRenderbufferStorage(buffer, format, width, height);
}

void Gl::TextureStorage2D(GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height) const {
  counts_.allocated += volume(width, height, 1) * stored_bytes(format);
  note_storage({Kind::texture, texture}, texture_bytes(levels, format, width, height, 1));
  counted_.TextureStorage2D(texture, levels, format, width, height);
}

void Gl::TextureStorage3D(GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height,
                          GLsizei depth) const {
  counts_.allocated += volume(width, height, depth) * stored_bytes(format);
  // Right for texture arrays, whose depth is the same at all levels; no 3D texture with mip levels is used.
  note_storage({Kind::texture, texture}, texture_bytes(levels, format, width, height, depth));
  counted_.TextureStorage3D(texture, levels, format, width, height, depth);
}

void Gl::TextureSubImage2D(GLuint texture, GLint level, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                           GLenum type, const void* pixels) const {
  counts_.bytes += static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * texel_bytes(format, type);
  counted_.TextureSubImage2D(texture, level, x, y, width, height, format, type, pixels);
}

void Gl::TextureSubImage3D(GLuint texture, GLint level, GLint x, GLint y, GLint z, GLsizei width, GLsizei height,
                           GLsizei depth, GLenum format, GLenum type, const void* pixels) const {
  counts_.bytes += static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                   static_cast<std::size_t>(depth) * texel_bytes(format, type);
  counted_.TextureSubImage3D(texture, level, x, y, z, width, height, depth, format, type, pixels);
}

void Gl::UseProgram(GLuint program) const {
  ++counts_.programs;
  counted_.UseProgram(program);
}

bool Gl::is_software() const {
  const GLubyte* text = GetString(GL_RENDERER);
  const std::string_view name = text ? reinterpret_cast<const char*>(text) : "";
  return name.find("llvmpipe") != name.npos || name.find("softpipe") != name.npos || name.find("SWR") != name.npos;
}

std::string Gl::load(const LoadFunction& find) {
  std::string missing;
  const auto get = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(find(name));
    if (!function && missing.empty()) missing = name;
  };
  get(AttachShader, "glAttachShader");
  get(BeginQuery, "glBeginQuery");
  get(BindBufferBase, "glBindBufferBase");
  get(BindFramebuffer, "glBindFramebuffer");
  get(counted_.BindTextureUnit, "glBindTextureUnit");
  get(BindVertexArray, "glBindVertexArray");
  get(BlendEquation, "glBlendEquation");
  get(BlendFunc, "glBlendFunc");
  get(CheckNamedFramebufferStatus, "glCheckNamedFramebufferStatus");
  get(ClearNamedBufferData, "glClearNamedBufferData");
  get(ClearNamedFramebufferfv, "glClearNamedFramebufferfv");
  get(ClientWaitSync, "glClientWaitSync");
  get(ClipControl, "glClipControl");
  get(ColorMask, "glColorMask");
  get(CompileShader, "glCompileShader");
  get(CopyTextureSubImage3D, "glCopyTextureSubImage3D");
  get(CreateBuffers, "glCreateBuffers");
  get(CreateFramebuffers, "glCreateFramebuffers");
  get(CreateProgram, "glCreateProgram");
  get(CreateQueries, "glCreateQueries");
  get(CreateRenderbuffers, "glCreateRenderbuffers");
  get(CreateShader, "glCreateShader");
  get(CreateTextures, "glCreateTextures");
  get(CreateVertexArrays, "glCreateVertexArrays");
  get(counted_.DeleteBuffers, "glDeleteBuffers");
  get(DeleteFramebuffers, "glDeleteFramebuffers");
  get(DeleteProgram, "glDeleteProgram");
  get(DeleteQueries, "glDeleteQueries");
  get(counted_.DeleteRenderbuffers, "glDeleteRenderbuffers");
  get(DeleteShader, "glDeleteShader");
  get(DeleteSync, "glDeleteSync");
  get(counted_.DeleteTextures, "glDeleteTextures");
  get(DeleteVertexArrays, "glDeleteVertexArrays");
  get(DepthFunc, "glDepthFunc");
  get(DepthMask, "glDepthMask");
  get(Disable, "glDisable");
  get(DispatchCompute, "glDispatchCompute");
  get(counted_.DrawArrays, "glDrawArrays");
  get(counted_.DrawElements, "glDrawElements");
  get(counted_.DrawElementsInstanced, "glDrawElementsInstanced");
  get(Enable, "glEnable");
  get(EndQuery, "glEndQuery");
  get(EnableVertexArrayAttrib, "glEnableVertexArrayAttrib");
  get(FenceSync, "glFenceSync");
  get(Finish, "glFinish");
  get(Flush, "glFlush");
  get(GetError, "glGetError");
  get(GetGraphicsResetStatus, "glGetGraphicsResetStatus");
  get(GetInteger64v, "glGetInteger64v");
  get(GetIntegerv, "glGetIntegerv");
  get(GetNamedBufferSubData, "glGetNamedBufferSubData");
  get(GetProgramInfoLog, "glGetProgramInfoLog");
  get(GetProgramiv, "glGetProgramiv");
  get(GetQueryObjectui64v, "glGetQueryObjectui64v");
  get(GetShaderInfoLog, "glGetShaderInfoLog");
  get(GetShaderiv, "glGetShaderiv");
  get(GetString, "glGetString");
  get(LinkProgram, "glLinkProgram");
  get(MemoryBarrier, "glMemoryBarrier");
  get(counted_.NamedBufferData, "glNamedBufferData");
  get(counted_.NamedBufferSubData, "glNamedBufferSubData");
  get(NamedFramebufferRenderbuffer, "glNamedFramebufferRenderbuffer");
  get(NamedFramebufferTexture, "glNamedFramebufferTexture");
  get(counted_.NamedRenderbufferStorage, "glNamedRenderbufferStorage");
  get(PixelStorei, "glPixelStorei");
  get(ReadPixels, "glReadPixels");
  get(Scissor, "glScissor");
  get(ShaderSource, "glShaderSource");
  get(TextureParameteri, "glTextureParameteri");
  get(counted_.TextureStorage2D, "glTextureStorage2D");
  get(counted_.TextureStorage3D, "glTextureStorage3D");
  get(counted_.TextureSubImage2D, "glTextureSubImage2D");
  get(counted_.TextureSubImage3D, "glTextureSubImage3D");
  get(GenerateTextureMipmap, "glGenerateTextureMipmap");
  get(Uniform1f, "glUniform1f");
  get(Uniform2i, "glUniform2i");
  get(Uniform3f, "glUniform3f");
  get(Uniform1i, "glUniform1i");
  get(Uniform1ui, "glUniform1ui");
  get(GetUniformLocation, "glGetUniformLocation");
  get(UniformMatrix4fv, "glUniformMatrix4fv");
  get(counted_.UseProgram, "glUseProgram");
  get(VertexArrayAttribBinding, "glVertexArrayAttribBinding");
  get(VertexArrayAttribFormat, "glVertexArrayAttribFormat");
  get(VertexArrayElementBuffer, "glVertexArrayElementBuffer");
  get(VertexArrayVertexBuffer, "glVertexArrayVertexBuffer");
  get(Viewport, "glViewport");
  return missing;
}

}  // namespace pelage
