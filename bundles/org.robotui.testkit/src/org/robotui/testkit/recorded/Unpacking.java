package org.robotui.testkit.recorded;

import java.io.IOException;
import java.io.OutputStream;
import java.lang.ProcessBuilder.Redirect;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;

/** How the chunks of a bag are compressed. */
enum Unpacking {
  /** Not at all. */
  NONE {
    @Override
    ByteBuffer unpack(ByteBuffer packed, int size) {
      return packed;
    }
  },
  /** By the frame format of lz4. */
  LZ4 {
    @Override
    ByteBuffer unpack(ByteBuffer packed, int size) {
      return Lz4.frame(packed, size);
    }
  },
  /** By bzip2, whose program unpacks it. */
  BZ2 {
    @Override
    ByteBuffer unpack(ByteBuffer packed, int size) throws IOException {
      byte[] bytes = new byte[packed.remaining()];
      packed.get(bytes);
      Process bzip2 = new ProcessBuilder("bzip2", "-dc").redirectError(Redirect.DISCARD).start();
      // Its output is read while it is fed: neither pipe holds a chunk.
      CompletableFuture<Void> fed = CompletableFuture.runAsync(() -> feed(bzip2, bytes));
      byte[] out = bzip2.getInputStream().readAllBytes();
      fed.join();
      return ByteBuffer.wrap(out).order(ByteOrder.LITTLE_ENDIAN);
    }
  };

  abstract ByteBuffer unpack(ByteBuffer packed, int size) throws IOException;

  /** By the name that a bag writes. */
  static Unpacking of(String name) {
    return valueOf(name.toUpperCase(Locale.ROOT));
  }

  private static void feed(Process program, byte[] bytes) {
    try (OutputStream in = program.getOutputStream()) {
      in.write(bytes);
    } catch (IOException e) {
      // What it did not take is missing in what it gives, and the bag cannot be read: its reader says so.
    }
  }
}
