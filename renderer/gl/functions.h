// The OpenGL 4.5 functions that Pelage uses, loaded through the context (never linked: see docs/headless-gl.md).
#pragma once

#include <GL/glcorearb.h>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>

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
  PFNGLATTACHSHADERPROC AttachShader = nullptr;
  PFNGLBEGINQUERYPROC BeginQuery = nullptr;
  PFNGLBINDBUFFERBASEPROC BindBufferBase = nullptr;
  PFNGLBINDFRAMEBUFFERPROC BindFramebuffer = nullptr;
  PFNGLBINDVERTEXARRAYPROC BindVertexArray = nullptr;
  PFNGLBLENDEQUATIONPROC BlendEquation = nullptr;
  PFNGLBLENDFUNCPROC BlendFunc = nullptr;
  PFNGLCHECKNAMEDFRAMEBUFFERSTATUSPROC CheckNamedFramebufferStatus = nullptr;
  PFNGLCLEARNAMEDBUFFERDATAPROC ClearNamedBufferData = nullptr;
  PFNGLCLEARNAMEDFRAMEBUFFERFVPROC ClearNamedFramebufferfv = nullptr;
  PFNGLCLIENTWAITSYNCPROC ClientWaitSync = nullptr;
  PFNGLCLIPCONTROLPROC ClipControl = nullptr;
  PFNGLCOLORMASKPROC ColorMask = nullptr;
  PFNGLCOMPILESHADERPROC CompileShader = nullptr;
  PFNGLCOPYTEXTURESUBIMAGE3DPROC CopyTextureSubImage3D = nullptr;
  PFNGLCREATEBUFFERSPROC CreateBuffers = nullptr;
  PFNGLCREATEFRAMEBUFFERSPROC CreateFramebuffers = nullptr;
  PFNGLCREATEPROGRAMPROC CreateProgram = nullptr;
  PFNGLCREATEQUERIESPROC CreateQueries = nullptr;
  PFNGLCREATERENDERBUFFERSPROC CreateRenderbuffers = nullptr;
  PFNGLCREATESHADERPROC CreateShader = nullptr;
  PFNGLCREATETEXTURESPROC CreateTextures = nullptr;
  PFNGLCREATEVERTEXARRAYSPROC CreateVertexArrays = nullptr;
  PFNGLDELETEFRAMEBUFFERSPROC DeleteFramebuffers = nullptr;
  PFNGLDELETEPROGRAMPROC DeleteProgram = nullptr;
  PFNGLDELETEQUERIESPROC DeleteQueries = nullptr;
  PFNGLDELETESHADERPROC DeleteShader = nullptr;
  PFNGLDELETESYNCPROC DeleteSync = nullptr;
  PFNGLDELETEVERTEXARRAYSPROC DeleteVertexArrays = nullptr;
  PFNGLDEPTHFUNCPROC DepthFunc = nullptr;
  PFNGLDEPTHMASKPROC DepthMask = nullptr;
  PFNGLDISABLEPROC Disable = nullptr;
  PFNGLDISPATCHCOMPUTEPROC DispatchCompute = nullptr;
  PFNGLENABLEPROC Enable = nullptr;
  PFNGLENDQUERYPROC EndQuery = nullptr;
  PFNGLENABLEVERTEXARRAYATTRIBPROC EnableVertexArrayAttrib = nullptr;
  PFNGLFENCESYNCPROC FenceSync = nullptr;
  PFNGLFINISHPROC Finish = nullptr;
  PFNGLFLUSHPROC Flush = nullptr;
  PFNGLGETERRORPROC GetError = nullptr;
  PFNGLGETGRAPHICSRESETSTATUSPROC GetGraphicsResetStatus = nullptr;
  PFNGLGETINTEGER64VPROC GetInteger64v = nullptr;
  PFNGLGETINTEGERVPROC GetIntegerv = nullptr;
  PFNGLGETNAMEDBUFFERSUBDATAPROC GetNamedBufferSubData = nullptr;
  PFNGLGETPROGRAMINFOLOGPROC GetProgramInfoLog = nullptr;
  PFNGLGETPROGRAMIVPROC GetProgramiv = nullptr;
  PFNGLGETQUERYOBJECTUI64VPROC GetQueryObjectui64v = nullptr;
  PFNGLGETSHADERINFOLOGPROC GetShaderInfoLog = nullptr;
  PFNGLGETSHADERIVPROC GetShaderiv = nullptr;
  PFNGLGETSTRINGPROC GetString = nullptr;
  PFNGLLINKPROGRAMPROC LinkProgram = nullptr;
  PFNGLMEMORYBARRIERPROC MemoryBarrier = nullptr;
  PFNGLNAMEDFRAMEBUFFERRENDERBUFFERPROC NamedFramebufferRenderbuffer = nullptr;
  PFNGLNAMEDFRAMEBUFFERTEXTUREPROC NamedFramebufferTexture = nullptr;
  PFNGLPIXELSTOREIPROC PixelStorei = nullptr;
  PFNGLREADPIXELSPROC ReadPixels = nullptr;
  PFNGLSCISSORPROC Scissor = nullptr;
  PFNGLSHADERSOURCEPROC ShaderSource = nullptr;
  PFNGLTEXTUREPARAMETERIPROC TextureParameteri = nullptr;
  PFNGLGENERATETEXTUREMIPMAPPROC GenerateTextureMipmap = nullptr;
  PFNGLUNIFORM1FPROC Uniform1f = nullptr;
  PFNGLUNIFORM1IPROC Uniform1i = nullptr;
  PFNGLUNIFORM1UIPROC Uniform1ui = nullptr;
  PFNGLUNIFORM2IPROC Uniform2i = nullptr;
  PFNGLUNIFORM3FPROC Uniform3f = nullptr;
  PFNGLGETUNIFORMLOCATIONPROC GetUniformLocation = nullptr;
  PFNGLUNIFORMMATRIX4FVPROC UniformMatrix4fv = nullptr;
  PFNGLVERTEXARRAYATTRIBBINDINGPROC VertexArrayAttribBinding = nullptr;
  PFNGLVERTEXARRAYATTRIBFORMATPROC VertexArrayAttribFormat = nullptr;
  PFNGLVERTEXARRAYELEMENTBUFFERPROC VertexArrayElementBuffer = nullptr;
  PFNGLVERTEXARRAYVERTEXBUFFERPROC VertexArrayVertexBuffer = nullptr;
  PFNGLVIEWPORTPROC Viewport = nullptr;

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

  /// Returns whether the CPU draws, as Mesa's software drivers have it.
  bool is_software() const;
  /// Loads every function. Returns the first name that the context lacks, or "".
  std::string load(const LoadFunction& find);

 private:
  struct Counted {
    PFNGLBINDTEXTUREUNITPROC BindTextureUnit = nullptr;
    PFNGLDELETEBUFFERSPROC DeleteBuffers = nullptr;
    PFNGLDELETERENDERBUFFERSPROC DeleteRenderbuffers = nullptr;
    PFNGLDELETETEXTURESPROC DeleteTextures = nullptr;
    PFNGLDRAWARRAYSPROC DrawArrays = nullptr;
    PFNGLDRAWELEMENTSPROC DrawElements = nullptr;
    PFNGLDRAWELEMENTSINSTANCEDPROC DrawElementsInstanced = nullptr;
    PFNGLNAMEDBUFFERDATAPROC NamedBufferData = nullptr;
    PFNGLNAMEDBUFFERSUBDATAPROC NamedBufferSubData = nullptr;
    PFNGLNAMEDRENDERBUFFERSTORAGEPROC NamedRenderbufferStorage = nullptr;
    PFNGLTEXTURESTORAGE2DPROC TextureStorage2D = nullptr;
    PFNGLTEXTURESTORAGE3DPROC TextureStorage3D = nullptr;
    PFNGLTEXTURESUBIMAGE2DPROC TextureSubImage2D = nullptr;
    PFNGLTEXTURESUBIMAGE3DPROC TextureSubImage3D = nullptr;
    PFNGLUSEPROGRAMPROC UseProgram = nullptr;
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
