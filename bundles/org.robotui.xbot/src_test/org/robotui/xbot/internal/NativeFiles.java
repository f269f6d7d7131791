package org.robotui.xbot.internal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;

/** The files that the native side is tested with, too. */
final class NativeFiles {
  private NativeFiles() {}

  static Path of(String path) {
    Stream<Path> places = Stream.concat(Optional.ofNullable(System.getenv("ROBOTUI_ROOT")).stream().map(Path::of),
        Stream.iterate(Path.of("").toAbsolutePath(), p -> p != null, Path::getParent));
    return places.map(p -> p.resolve("rt-native").resolve(path)).filter(Files::exists).findFirst()
        .orElseThrow(
            () -> new AssertionError("rt-native/" + path + " is not found: set ROBOTUI_ROOT to the repository"));
  }

  static Memory vector(String name) throws IOException {
    byte[] bytes = Files.readAllBytes(of("tests/vectors/" + name + ".bin"));
    return new Memory(ByteBuffer.allocateDirect(bytes.length).order(ByteOrder.LITTLE_ENDIAN).put(bytes).flip());
  }
}
