package org.robotui.recording.internal.codec;

import com.github.luben.zstd.Zstd;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.Optional;
import net.jpountz.lz4.LZ4FrameOutputStream;
import org.robotui.recording.ChunkCompression;

/** Compresses chunks of recordings. */
public final class ChunkEncoder {

  /** As fast as it goes: a recorder runs beside what it records. */
  private static final int ZSTD_LEVEL = 1;

  private static final long UNKNOWN_SIZE = -1;

  private final ChunkCompression compression;
  private final Lz4Library library;

  public ChunkEncoder(ChunkCompression compression) {
    this.compression = compression;
    library = Lz4Library.load();
  }

  /** Empty where it does not become smaller, so that it is better left as it is. */
  public Optional<byte[]> encode(byte[] plain, int length) {
    byte[] smaller = switch (compression) {
      case NONE -> plain;
      case LZ4 -> lz4(plain, length);
      case ZSTD -> zstd(plain, length);
    };
    return smaller.length < length ? Optional.of(smaller) : Optional.empty();
  }

  private static byte[] zstd(byte[] plain, int length) {
    byte[] out = new byte[(int) Zstd.compressBound(length)];
    long written = Zstd.compressByteArray(out, 0, out.length, plain, 0, length, ZSTD_LEVEL);
    return Zstd.isError(written) ? plain : Arrays.copyOf(out, (int) written);
  }

  private byte[] lz4(byte[] plain, int length) {
    ByteArrayOutputStream out = new ByteArrayOutputStream(length / 2);
    try (LZ4FrameOutputStream frame = new LZ4FrameOutputStream(out, LZ4FrameOutputStream.BLOCKSIZE.SIZE_256KB,
        UNKNOWN_SIZE, library.compressor(), library.sums(), LZ4FrameOutputStream.FLG.Bits.BLOCK_INDEPENDENCE)) {
      frame.write(plain, 0, length);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return out.toByteArray();
  }
}
