#include "renderer/gl/functions.h"

namespace pelage {

std::string Gl::load(const LoadFunction& find) {
  std::string missing;
  const auto get = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(find(name));
    if (!function && missing.empty()) missing = name;
  };
  get(AttachShader, "glAttachShader");
  get(BindBufferBase, "glBindBufferBase");
  get(BindFramebuffer, "glBindFramebuffer");
  get(BindTextureUnit, "glBindTextureUnit");
  get(BindVertexArray, "glBindVertexArray");
  get(BlendEquation, "glBlendEquation");
  get(BlendFunc, "glBlendFunc");
  get(BlitNamedFramebuffer, "glBlitNamedFramebuffer");
  get(CheckNamedFramebufferStatus, "glCheckNamedFramebufferStatus");
  get(ClearNamedFramebufferfv, "glClearNamedFramebufferfv");
  get(ClientWaitSync, "glClientWaitSync");
  get(ClipControl, "glClipControl");
  get(ColorMask, "glColorMask");
  get(CompileShader, "glCompileShader");
  get(CopyTextureSubImage3D, "glCopyTextureSubImage3D");
  get(CreateBuffers, "glCreateBuffers");
  get(CreateFramebuffers, "glCreateFramebuffers");
  get(CreateProgram, "glCreateProgram");
  get(CreateRenderbuffers, "glCreateRenderbuffers");
  get(CreateShader, "glCreateShader");
  get(CreateTextures, "glCreateTextures");
  get(CreateVertexArrays, "glCreateVertexArrays");
  get(DeleteBuffers, "glDeleteBuffers");
  get(DeleteFramebuffers, "glDeleteFramebuffers");
  get(DeleteProgram, "glDeleteProgram");
  get(DeleteRenderbuffers, "glDeleteRenderbuffers");
  get(DeleteShader, "glDeleteShader");
  get(DeleteSync, "glDeleteSync");
  get(DeleteTextures, "glDeleteTextures");
  get(DeleteVertexArrays, "glDeleteVertexArrays");
  get(DepthFunc, "glDepthFunc");
  get(DepthMask, "glDepthMask");
  get(Disable, "glDisable");
  get(DrawArrays, "glDrawArrays");
  get(DrawElements, "glDrawElements");
  get(DrawElementsInstanced, "glDrawElementsInstanced");
  get(Enable, "glEnable");
  get(EnableVertexArrayAttrib, "glEnableVertexArrayAttrib");
  get(FenceSync, "glFenceSync");
  get(Finish, "glFinish");
  get(Flush, "glFlush");
  get(GetError, "glGetError");
  get(GetIntegerv, "glGetIntegerv");
  get(GetProgramInfoLog, "glGetProgramInfoLog");
  get(GetProgramiv, "glGetProgramiv");
  get(GetShaderInfoLog, "glGetShaderInfoLog");
  get(GetShaderiv, "glGetShaderiv");
  get(GetString, "glGetString");
  get(LinkProgram, "glLinkProgram");
  get(NamedBufferData, "glNamedBufferData");
  get(NamedBufferSubData, "glNamedBufferSubData");
  get(NamedFramebufferRenderbuffer, "glNamedFramebufferRenderbuffer");
  get(NamedFramebufferTexture, "glNamedFramebufferTexture");
  get(NamedRenderbufferStorageMultisample, "glNamedRenderbufferStorageMultisample");
  get(PixelStorei, "glPixelStorei");
  get(ReadPixels, "glReadPixels");
  get(ShaderSource, "glShaderSource");
  get(TextureParameteri, "glTextureParameteri");
  get(TextureStorage2D, "glTextureStorage2D");
  get(TextureStorage3D, "glTextureStorage3D");
  get(TextureSubImage3D, "glTextureSubImage3D");
  get(GenerateTextureMipmap, "glGenerateTextureMipmap");
  get(Uniform1f, "glUniform1f");
  get(Uniform3f, "glUniform3f");
  get(Uniform1i, "glUniform1i");
  get(GetUniformLocation, "glGetUniformLocation");
  get(UniformMatrix4fv, "glUniformMatrix4fv");
  get(UseProgram, "glUseProgram");
  get(VertexArrayAttribBinding, "glVertexArrayAttribBinding");
  get(VertexArrayAttribFormat, "glVertexArrayAttribFormat");
  get(VertexArrayElementBuffer, "glVertexArrayElementBuffer");
  get(VertexArrayVertexBuffer, "glVertexArrayVertexBuffer");
  get(Viewport, "glViewport");
  return missing;
}

}  // namespace pelage
