package org.robotui.gl.internal.draw;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Collectors;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.Program;

/** The shaders of a context, each compiled when it is first needed. */
public final class Programs {
  private final Gpu gpu;
  private final Map<Shader, Program> programs = new HashMap<>();

  Programs(Gpu gpu) {
    this.gpu = gpu;
  }

  Program get(Shader shader) {
    return programs.computeIfAbsent(shader, this::compile);
  }

  private Program compile(Shader shader) {
    String head = shader.traits().stream().sorted().map(trait -> "#define " + trait + "\n")
        .collect(Collectors.joining("", "#version 330 core\n", ""));
    return new Program(gpu, head + text(shader.name() + ".vert"), head + text(shader.name() + ".frag"));
  }

  private static String text(String name) {
    try (InputStream in = Programs.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new IllegalStateException("the shader " + name + " is not in the bundle");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException("the shader " + name + " cannot be read", e);
    }
  }

  void delete() {
    programs.values().forEach(Program::delete);
    programs.clear();
  }
}
