package org.robotui.recording.internal.mcap;

import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMetadata;
import org.robotui.recording.RecordedSchema;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingWriter;
import org.robotui.recording.WriterOptions;
import org.robotui.recording.internal.codec.ChunkEncoder;
import org.robotui.recording.internal.io.PackedBytes;

/** Writes MCAP. A thread of its own writes chunks that are old enough, as nobody else may come for long. */
public final class McapWriter implements RecordingWriter {

  private static final int MOST_CHANNELS = 0xffff;
  private static final int MOST_MESSAGE = 64 << 20;
  private static final String LIBRARY = "robotui";

  private final McapFile file;
  private final WriterOptions options;
  private final ChunkEncoder encoder;
  private final McapChunk chunk = new McapChunk();
  private final PackedBytes buffer = new PackedBytes(1 << 16);
  private final McapTail tail = new McapTail();
  private final List<RecordedChannel> channels = new ArrayList<>();
  private final Map<RecordedSchema, Integer> schemas = new LinkedHashMap<>();
  private final Set<Integer> written = new HashSet<>();
  private final Set<RecordedSchema> writtenSchemas = new HashSet<>();
  private final ScheduledExecutorService timer =
      Executors
          .newSingleThreadScheduledExecutor(run -> Thread.ofPlatform().daemon().name("recording-flush").unstarted(run));
  private long chunks;
  private Optional<RecordingException> failure = Optional.empty();
  private boolean closed;

  private McapWriter(McapFile file, WriterOptions options) {
    this.file = file;
    this.options = options;
    encoder = new ChunkEncoder(options.compression());
  }

  public static McapWriter create(Path path, WriterOptions options) throws RecordingException {
    McapFile file = McapFile.create(path);
    McapWriter writer = new McapWriter(file, options);
    try {
      writer.begin();
    } catch (RecordingException e) {
      file.close();
      throw e;
    }
    return writer;
  }

  private void begin() throws RecordingException {
    byte[] magic = McapFormat.magic();
    buffer.raw(magic, 0, magic.length);
    int record = McapRecords.begin(buffer, McapFormat.HEADER);
    buffer.text(options.profile()).text(LIBRARY).end(record, Long.BYTES);
    writeBuffer();
  }

  @Override
  public synchronized RecordedChannel channel(String topic, String encoding, RecordedSchema schema,
      Map<String, String> metadata) {
    if (channels.size() == MOST_CHANNELS) {
      throw new IllegalStateException("a recording has " + MOST_CHANNELS + " channels at most");
    }
    RecordedChannel channel = new RecordedChannel(channels.size(), topic, encoding, schema, metadata);
    channels.add(channel);
    if (!schema.equals(RecordedSchema.NONE)) {
      schemas.putIfAbsent(schema, schemas.size() + 1);
    }
    return channel;
  }

  @Override
  public synchronized void write(RecordedChannel channel, long logTime, long publishTime, long sequence,
      ByteBuffer data) throws RecordingException {
    check(data);
    if (channel.id() < 0 || channel.id() >= channels.size() || channels.get(channel.id()) != channel) {
      throw new IllegalArgumentException("the channel of " + channel.topic() + " is not of this recording");
    }
    if (!chunk.isEmpty() && chunk.size() + (long) data.remaining() > MOST_MESSAGE) {
      writeChunk();
    }
    if (chunk.isEmpty()) {
      long filled = chunks;
      timer.schedule(() -> writeOld(filled), options.chunkTime().toNanos(), TimeUnit.NANOSECONDS);
    }
    describe(channel);
    chunk.message(channel.id(), logTime, publishTime, sequence, data);
    tail.message(channel.id(), logTime);
    if (chunk.size() >= options.chunkBytes()) {
      writeChunk();
    }
  }

  private void describe(RecordedChannel channel) {
    if (written.add(channel.id())) {
      int schema = schemas.getOrDefault(channel.schema(), 0);
      if (schema != 0 && writtenSchemas.add(channel.schema())) {
        chunk.schema(schema, channel);
      }
      chunk.channel(channel, schema);
    }
  }

  /** Channels without a message are told too. */
  private void describeSilent() throws RecordingException {
    for (RecordedChannel channel : channels) {
      describe(channel);
    }
    chunk.putDefinitions(buffer);
    writeBuffer();
  }

  private void check(ByteBuffer data) throws RecordingException {
    if (closed) {
      throw new IllegalStateException("the recording is closed");
    }
    if (failure.isPresent()) {
      throw failure.get();
    }
    if (data.remaining() > MOST_MESSAGE) {
      throw new IllegalArgumentException(data.remaining() + " bytes are more than the " + MOST_MESSAGE + " possible");
    }
  }

  /** Nobody hears of a failure here, so that the next call tells it. */
  private synchronized void writeOld(long filled) {
    if (filled == chunks && !closed && failure.isEmpty()) {
      try {
        writeChunk();
      } catch (RecordingException e) {
        failure = Optional.of(e);
      }
    }
  }

  private void writeChunk() throws RecordingException {
    if (!chunk.isEmpty()) {
      chunks++;
      try {
        tail.chunk(chunk.write(file, encoder, options.compression().word()));
      } finally {
        chunk.clear();
      }
    }
  }

  private void writeBuffer() throws RecordingException {
    try {
      file.write(buffer);
    } finally {
      buffer.clear();
    }
  }

  @Override
  public synchronized void attach(String name, String type, long logTime, long createTime, ByteBuffer content)
      throws RecordingException {
    check(content);
    writeChunk();
    long offset = file.position();
    int record = McapRecords.begin(buffer, McapFormat.ATTACHMENT);
    buffer.i64(logTime).i64(createTime).text(name).text(type).i64(content.remaining()).raw(content);
    int from = record + Long.BYTES;
    buffer.u32(McapSource.sum(buffer.array(), from, buffer.size() - from)).end(record, Long.BYTES);
    PackedBytes entry = new PackedBytes(128).i64(offset).i64(buffer.size()).i64(logTime).i64(createTime)
        .i64(content.remaining()).text(name).text(type);
    writeBuffer();
    tail.attachment(entry);
  }

  @Override
  public synchronized void note(RecordedMetadata metadata) throws RecordingException {
    check(ByteBuffer.allocate(0));
    writeChunk();
    long offset = file.position();
    int record = McapRecords.begin(buffer, McapFormat.METADATA);
    buffer.text(metadata.name()).texts(metadata.values()).end(record, Long.BYTES);
    PackedBytes entry = new PackedBytes(128).i64(offset).i64(buffer.size()).text(metadata.name());
    writeBuffer();
    tail.metadata(entry);
  }

  @Override
  public synchronized void flush() throws RecordingException {
    check(ByteBuffer.allocate(0));
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
    timer.shutdownNow();
    try (file) {
      if (failure.isPresent()) {
        throw failure.get();
      }
      if (file.isWritable()) {
        writeChunk();
        describeSilent();
        tail.write(file, schemas, channels);
      }
    }
  }
}
