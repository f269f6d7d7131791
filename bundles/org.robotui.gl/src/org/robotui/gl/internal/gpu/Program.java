package org.robotui.gl.internal.gpu;

import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import org.robotui.gl.internal.gpu.Ledger.Kind;
import org.robotui.gl.shape.Rgba;

/** A pair of shaders. */
public final class Program {
  private final Gpu gpu;
  private final GL3 gl;
  private final int id;
  private final Map<String, Integer> places = new HashMap<>();

  /**
   * Compiles.
   *
   * @param gpu where
   * @param vertex what is done with each vertex
   * @param fragment what is done with each pixel
   */
  public Program(Gpu gpu, String vertex, String fragment) {
    this.gpu = gpu;
    gl = gpu.gl();
    id = gpu.made(Kind.PROGRAM, gl.glCreateProgram());
    int first = compile(GL2ES2.GL_VERTEX_SHADER, vertex);
    int second = compile(GL2ES2.GL_FRAGMENT_SHADER, fragment);
    gl.glLinkProgram(id);
    requireLinked();
    gl.glDeleteShader(first);
    gl.glDeleteShader(second);
  }

  private int compile(int kind, String source) {
    int shader = gl.glCreateShader(kind);
    gl.glShaderSource(shader, 1, new String[]{source}, new int[]{source.getBytes(StandardCharsets.UTF_8).length}, 0);
    gl.glCompileShader(shader);
    int[] done = new int[1];
    gl.glGetShaderiv(shader, GL2ES2.GL_COMPILE_STATUS, done, 0);
    if (done[0] == 0) {
      byte[] log = new byte[1024];
      gl.glGetShaderInfoLog(shader, log.length, done, 0, log, 0);
      throw new GpuFailure("a shader does not compile: " + new String(log, 0, done[0], StandardCharsets.UTF_8));
    }
    gl.glAttachShader(id, shader);
    return shader;
  }

  private void requireLinked() {
    int[] done = new int[1];
    gl.glGetProgramiv(id, GL2ES2.GL_LINK_STATUS, done, 0);
    if (done[0] == 0) {
      byte[] log = new byte[1024];
      gl.glGetProgramInfoLog(id, log.length, done, 0, log, 0);
      throw new GpuFailure("shaders do not link: " + new String(log, 0, done[0], StandardCharsets.UTF_8));
    }
  }

  /** Makes it the one that is drawn with. */
  public void use() {
    gl.glUseProgram(id);
  }

  /**
   * Sets a matrix.
   *
   * @param name of the uniform
   * @param columns four columns of four
   */
  public void matrix(String name, float[] columns) {
    gl.glUniformMatrix4fv(place(name), 1, false, columns, 0);
  }

  /**
   * Sets a colour.
   *
   * @param name of the uniform
   * @param color the colour
   */
  public void color(String name, Rgba color) {
    gl.glUniform4f(place(name), color.red(), color.green(), color.blue(), color.alpha());
  }

  /**
   * Sets a number.
   *
   * @param name of the uniform
   * @param value the number
   */
  public void number(String name, float value) {
    gl.glUniform1f(place(name), value);
  }

  /**
   * Sets two numbers.
   *
   * @param name of the uniform
   * @param x the first
   * @param y the second
   */
  public void pair(String name, float x, float y) {
    gl.glUniform2f(place(name), x, y);
  }

  /**
   * Sets three numbers.
   *
   * @param name of the uniform
   * @param x the first
   * @param y the second
   * @param z the third
   */
  public void triple(String name, float x, float y, float z) {
    gl.glUniform3f(place(name), x, y, z);
  }

  /**
   * Sets a whole number without a sign.
   *
   * @param name of the uniform
   * @param value the number
   */
  public void whole(String name, int value) {
    gl.glUniform1ui(place(name), value);
  }

  /**
   * Says which texture is meant.
   *
   * @param name of the uniform
   * @param unit where the texture is bound
   */
  public void unit(String name, int unit) {
    gl.glUniform1i(place(name), unit);
  }

  /** A uniform that this variant of the shader does not have is at -1, which OpenGL ignores. */
  private int place(String name) {
    return places.computeIfAbsent(name, wanted -> gl.glGetUniformLocation(id, wanted));
  }

  /** Frees it. */
  public void delete() {
    gl.glDeleteProgram(id);
    gpu.ledger().freed(Kind.PROGRAM);
  }
}
