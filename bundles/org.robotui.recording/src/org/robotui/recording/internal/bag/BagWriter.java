package org.robotui.recording.internal.bag;

import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import org.robotui.recording.ChunkCompression;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMetadata;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingWriter;
import org.robotui.recording.WriterOptions;
import org.robotui.recording.internal.codec.ChunkEncoder;
import org.robotui.recording.internal.io.PackedBytes;

/**
 * Writes bags of ROS 1 (format 2.0). They have no place for files and notes, which are left out, and know no zstd, for
 * which LZ4 is taken.
 */
public final class BagWriter implements RecordingWriter {
  /** Of the first record, so that it can be written again with other numbers. */
  private static final int HEADER_ROOM = 4096;
  private static final long LAST_TIME = 0xffff_ffffL * 1_000_000_000L;
  private static final int MOST_MESSAGE = 64 << 20;

  private final BagFile file;
  private final WriterOptions options;
  private final Function<RecordedChannel, String> sums;
  private final ChunkEncoder encoder = ChunkEncoder.ofBags();
  private final List<RecordedChannel> channels = new ArrayList<>();
  private final Set<Integer> described = new HashSet<>();
  private final PackedBytes chunk = new PackedBytes(1 << 16);
  private final PackedBytes buffer = new PackedBytes(1 << 16);
  private final PackedBytes infos = new PackedBytes(1 << 12);
  /** Of the chunk: times and places of the messages of each connection. */
  private final Map<Integer, PackedBytes> index = new TreeMap<>();
  private long first = Long.MAX_VALUE;
  private long last;
  private int chunks;
  private boolean closed;

  private BagWriter(BagFile file, WriterOptions options, Function<RecordedChannel, String> sums) {
    this.file = file;
    this.options = options;
    this.sums = sums;
  }

  /**
   * Starts a bag.
   *
   * @param sums gives the MD5 sum of a channel's type, as ROS 1 computes it
   */
  public static BagWriter create(Path path, WriterOptions options, Function<RecordedChannel, String> sums)
      throws RecordingException {
    BagFile file = BagFile.create(path);
    try {
      BagWriter writer = new BagWriter(file, options, sums);
      file.append(ByteBuffer.wrap(BagOpener.MAGIC));
      file.append(writer.header(0));
      return writer;
    } catch (RecordingException e) {
      file.close();
      throw e;
    }
  }

  /** Whether messages of a channel may be in a bag. */
  public static boolean fits(RecordedChannel channel) {
    return channel.messageEncoding().equals("ros1") && channel.schema().encoding().equals("ros1msg");
  }

  private boolean isPlain() {
    return options.compression() == ChunkCompression.NONE;
  }

  private ByteBuffer header(long indexAt) {
    PackedBytes out = new PackedBytes(HEADER_ROOM);
    BagPacking.record(out, BagFields.BAG, fields -> {
      BagPacking.field(fields, "index_pos", value -> value.i64(indexAt));
      BagPacking.number(fields, "conn_count", indexAt == 0 ? 0 : described.size());
      BagPacking.number(fields, "chunk_count", indexAt == 0 ? 0 : chunks);
    }, data -> {
      while (data.size() < HEADER_ROOM) {
        data.u8(' ');
      }
    });
    return out.view();
  }

  @Override
  public synchronized RecordedChannel channel(String topic, String encoding, RecordedSchema schema,
      Map<String, String> metadata) {
    RecordedChannel channel = new RecordedChannel(channels.size(), topic, encoding, schema, metadata);
    if (!fits(channel)) {
      throw new IllegalArgumentException("the messages of " + topic + " are not of ROS 1");
    }
    channels.add(channel);
    return channel;
  }

  @Override
  public synchronized void write(RecordedChannel channel, long logTime, long publishTime, long sequence,
      ByteBuffer data) throws RecordingException {
    check(channel, logTime, data);
    if (described.add(channel.id())) {
      BagPacking.connection(chunk, channel.id(), channel, sums.apply(channel));
    }
    int at = chunk.size();
    BagPacking.record(chunk, BagFields.MESSAGE, fields -> {
      BagPacking.number(fields, "conn", channel.id());
      BagPacking.field(fields, "time", value -> BagPacking.time(value, logTime));
    }, content -> content.raw(data));
    PackedBytes places = index.computeIfAbsent(channel.id(), id -> new PackedBytes(1 << 10));
    BagPacking.time(places, logTime);
    places.u32(at);
    first = Math.min(first, logTime);
    last = Math.max(last, logTime);
    if (chunk.size() >= options.chunkBytes()) {
      writeChunk();
    }
  }

  private void check(RecordedChannel channel, long logTime, ByteBuffer data) throws RecordingException {
    if (closed) {
      throw new IllegalStateException("the recording is closed");
    }
    if (channel.id() < 0 || channel.id() >= channels.size() || channels.get(channel.id()) != channel) {
      throw new IllegalArgumentException("the channel of " + channel.topic() + " is not of this recording");
    }
    if (data.remaining() > MOST_MESSAGE) {
      throw new IllegalArgumentException(data.remaining() + " bytes are more than the " + MOST_MESSAGE + " possible");
    }
    if (logTime < 0 || logTime > LAST_TIME) {
      throw new RecordingException(file.path(), file.position(), "a message of " + channel.topic()
          + " was recorded at " + logTime + " ns since 1970, and bags have times from 1970 to 2106 alone");
    }
  }

  private void writeChunk() throws RecordingException {
    if (index.isEmpty()) {
      return;
    }
    long at = file.position();
    Optional<ByteBuffer> smaller = isPlain() ? Optional.empty() : encoder.encode(chunk.view());
    BagPacking.record(buffer, BagFields.CHUNK, fields -> {
      BagPacking.words(fields, "compression", smaller.isPresent() ? "lz4" : "none");
      BagPacking.number(fields, "size", chunk.size());
    }, data -> data.raw(smaller.orElseGet(chunk::view)));
    index.forEach((id, places) -> BagPacking.record(buffer, BagFields.INDEX, fields -> {
      BagPacking.number(fields, "ver", 1);
      BagPacking.number(fields, "conn", id);
      BagPacking.number(fields, "count", places.size() / (3 * Integer.BYTES));
    }, data -> data.raw(places.view())));
    info(at);
    chunks++;
    chunk.clear();
    index.clear();
    first = Long.MAX_VALUE;
    last = 0;
    flushBuffer();
  }

  private void info(long at) {
    BagPacking.record(infos, BagFields.CHUNK_INFO, fields -> {
      BagPacking.number(fields, "ver", 1);
      BagPacking.field(fields, "chunk_pos", value -> value.i64(at));
      BagPacking.field(fields, "start_time", value -> BagPacking.time(value, first));
      BagPacking.field(fields, "end_time", value -> BagPacking.time(value, last));
      BagPacking.number(fields, "count", index.size());
    }, data -> index.forEach((id, places) -> data.u32(id).u32(places.size() / (3 * Integer.BYTES))));
  }

  private void flushBuffer() throws RecordingException {
    try {
      file.append(buffer.view());
    } finally {
      buffer.clear();
    }
  }

  @Override
  public void attach(String name, String mediaType, long logTime, long createTime, ByteBuffer content) {
    // A bag has no place for it.
  }

  @Override
  public void note(RecordedMetadata metadata) {
    // A bag has no place for it.
  }

  @Override
  public synchronized void flush() throws RecordingException {
    writeChunk();
  }

  @Override
  public synchronized long size() {
    return file.position();
  }

  @Override
  public synchronized void close() throws RecordingException {
    if (closed) {
      return;
    }
    closed = true;
    try (file) {
      writeChunk();
      long indexAt = file.position();
      channels.stream().filter(channel -> described.contains(channel.id()))
          .forEach(channel -> BagPacking.connection(buffer, channel.id(), channel, sums.apply(channel)));
      buffer.raw(infos.view());
      flushBuffer();
      file.rewrite(header(indexAt), BagOpener.MAGIC.length);
    }
  }
}
