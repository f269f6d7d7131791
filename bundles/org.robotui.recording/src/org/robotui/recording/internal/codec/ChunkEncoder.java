package org.robotui.recording.internal.codec;

import com.github.luben.zstd.Zstd;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.util.Optional;
import net.jpountz.lz4.LZ4FrameOutputStream;
import net.jpountz.lz4.LZ4FrameOutputStream.FLG;
import org.robotui.recording.ChunkCompression;

/** Compresses chunks of recordings. For one thread at a time. */
public final class ChunkEncoder {

  /** As fast as it goes: a recorder runs beside what it records. */
  private static final int ZSTD_LEVEL = 1;

  private static final long UNKNOWN_SIZE = -1;

  private final ChunkCompression compression;
  private final FLG.Bits[] flags;
  private final Lz4Library library;
  private ByteBuffer compressed = ByteBuffer.allocateDirect(0);

  public ChunkEncoder(ChunkCompression compression) {
    this(compression, FLG.Bits.BLOCK_INDEPENDENCE);
  }

  private ChunkEncoder(ChunkCompression compression, FLG.Bits... flags) {
    this.compression = compression;
    this.flags = flags;
    library = Lz4Library.load();
  }

  /** Compresses by LZ4 as the library of ROS 1 reads it: with a checksum of all. */
  public static ChunkEncoder ofBags() {
    return new ChunkEncoder(ChunkCompression.LZ4, FLG.Bits.BLOCK_INDEPENDENCE, FLG.Bits.CONTENT_CHECKSUM);
  }

  /**
   * Empty where it does not become smaller, so that it is better left as it is.
   *
   * @param plain outside of the heap
   * @return valid until the next call
   */
  public Optional<ByteBuffer> encode(ByteBuffer plain) {
    ByteBuffer smaller = switch (compression) {
      case NONE -> plain;
      case LZ4 -> lz4(plain);
      case ZSTD -> zstd(plain);
    };
    return smaller.remaining() < plain.remaining() ? Optional.of(smaller) : Optional.empty();
  }

  private ByteBuffer zstd(ByteBuffer plain) {
    int bound = (int) Zstd.compressBound(plain.remaining());
    if (compressed.capacity() < bound) {
      compressed = ByteBuffer.allocateDirect(bound);
    }
    long written = Zstd.compressDirectByteBuffer(compressed, 0, bound, plain, plain.position(), plain.remaining(),
        ZSTD_LEVEL);
    return Zstd.isError(written) ? plain : compressed.slice(0, (int) written);
  }

  private ByteBuffer lz4(ByteBuffer plain) {
    byte[] array = new byte[plain.remaining()];
    plain.duplicate().get(array);
    return ByteBuffer.wrap(lz4(array));
  }

  private byte[] lz4(byte[] plain) {
    ByteArrayOutputStream out = new ByteArrayOutputStream(plain.length / 2);
    try (LZ4FrameOutputStream stream = new LZ4FrameOutputStream(out, LZ4FrameOutputStream.BLOCKSIZE.SIZE_256KB,
        UNKNOWN_SIZE, library.compressor(), library.sums(), flags)) {
      stream.write(plain, 0, plain.length);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return out.toByteArray();
  }
}
