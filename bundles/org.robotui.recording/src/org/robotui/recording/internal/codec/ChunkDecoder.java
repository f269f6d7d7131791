package org.robotui.recording.internal.codec;

import com.github.luben.zstd.Zstd;
import com.github.luben.zstd.ZstdException;
import com.github.luben.zstd.ZstdInputStreamNoFinalizer;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;
import org.apache.commons.compress.compressors.bzip2.BZip2CompressorInputStream;

/** Decompresses chunks of recordings; of damaged ones it gives what comes before the damage. */
public final class ChunkDecoder {

  /** No chunk may be larger, before or after compression. */
  public static final int MOST_BYTES = 128 << 20;

  private static final int STEP = 1 << 16;

  private final Lz4Frames lz4 = new Lz4Frames();

  /** Whether chunks with this word are known. MCAP says nothing for none, bags say so. */
  public boolean knows(String compression) {
    return switch (compression) {
      case "", "none", "lz4", "zstd", "bz2" -> true;
      default -> false;
    };
  }

  /**
   * @param compressed is what comes out, where nothing is compressed
   * @param expected how many bytes the file says that come out, at most {@link #MOST_BYTES}
   */
  public Decoded decode(String compression, byte[] compressed, int from, int length, int expected) {
    if (isPlain(compression)) {
      return complete(compressed, from, length, expected, Optional.empty());
    }
    if (compression.equals("zstd")) {
      Optional<Decoded> whole = zstdAtOnce(compressed, from, length, expected);
      if (whole.isPresent()) {
        return whole.get();
      }
    }
    GrowingBytes out = new GrowingBytes(expected, Math.max(STEP, (int) Math.min(MOST_BYTES, 16L * length)));
    Optional<String> problem = Optional.empty();
    try {
      if (compression.equals("lz4")) {
        lz4.decode(compressed, from, from + length, out);
      } else {
        decode(compression, new ByteArrayInputStream(compressed, from, length), out);
      }
    } catch (IOException | RuntimeException e) {
      // the libraries say by many an exception that bytes are no good
      problem = Optional.of("its " + compression + " is damaged: " + e.getMessage());
    }
    return complete(out.array(), 0, out.length(), expected, problem);
  }

  /** Whether this word says that nothing is compressed. */
  public static boolean isPlain(String compression) {
    return compression.isEmpty() || compression.equals("none");
  }

  private static Decoded complete(byte[] bytes, int from, int length, int expected, Optional<String> problem) {
    Optional<String> lacking = problem.isPresent() || length == expected ? problem
        : Optional.of("it has " + length + " bytes after decompression where " + expected + " should be");
    return new Decoded(bytes, from, length, lacking);
  }

  /** Twice as fast as a stream. Lengths that nobody has seen are left to the stream, which makes room as it goes. */
  private static Optional<Decoded> zstdAtOnce(byte[] compressed, int from, int length, int expected) {
    if (expected > Math.max(1 << 22, 64L * length)) {
      return Optional.empty();
    }
    byte[] out = new byte[expected];
    try {
      long written = Zstd.decompressByteArray(out, 0, expected, compressed, from, length);
      return written == expected ? Optional.of(new Decoded(out, 0, expected, Optional.empty())) : Optional.empty();
    } catch (ZstdException e) {
      // the stream says what is wrong, and gives what comes before
      return Optional.empty();
    }
  }

  private static void decode(String compression, InputStream compressed, GrowingBytes out) throws IOException {
    try (InputStream plain = compression.equals("zstd") ? new ZstdInputStreamNoFinalizer(compressed)
        : new BZip2CompressorInputStream(compressed)) {
      for (int room = out.room(STEP); room > 0; room = out.room(STEP)) {
        int read = plain.read(out.array(), out.length(), room);
        if (read < 0) {
          return;
        }
        out.written(read);
      }
      if (plain.read() >= 0) {
        throw new IOException("more than " + out.length() + " bytes come out");
      }
    }
  }
}
