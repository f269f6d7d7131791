package org.robotui.rfic.recording.internal.export;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingPart;
import org.robotui.recording.RecordingReader;
import org.robotui.rfic.recording.internal.file.ChannelFormats;

/** Writes messages of a recording into files that other programs read, one for each topic. For one thread. */
public final class TopicExport {
  private static final int LONGEST_NAME = 100;

  private final RecordingReader recording;
  private final RecordingPart part;
  private final Path folder;
  private final ExportFormat format;
  private final Map<Integer, TopicFile> files = new LinkedHashMap<>();
  private final List<ExportedFile> leftOut = new ArrayList<>();
  private final Set<String> names = new HashSet<>();

  /**
   * Writes nothing yet.
   *
   * @param recording is read
   * @param part what of it
   * @param folder where files are written; it is made where it is not there
   * @param format how
   */
  public TopicExport(RecordingReader recording, RecordingPart part, Path folder, ExportFormat format) {
    this.recording = recording;
    this.part = part;
    this.folder = folder;
    this.format = format;
  }

  /**
   * Writes all files.
   *
   * @param formats knows how messages are read
   * @return what became of each topic
   * @throws IOException where something cannot be read or written at all, or a file is there already
   */
  public List<ExportedFile> run(ChannelFormats formats) throws IOException {
    for (RecordedChannel channel : recording.channels()) {
      if (part.channels().test(channel) && recording.messageCounts().getOrDefault(channel.id(), 0L) > 0) {
        add(channel, formats.of(channel));
      }
    }
    List<ExportedFile> outcome = new ArrayList<>(leftOut);
    if (!files.isEmpty()) {
      write();
    }
    files.values().forEach(each -> outcome.add(each.outcome()));
    return outcome;
  }

  private void add(RecordedChannel channel, PayloadFormat read) throws IOException {
    Optional<PayloadFormat.Reading<DynamicRecord>> reading = TopicFile.reading(read);
    if (reading.isEmpty()) {
      leftOut.add(new ExportedFile(channel.topic(), Optional.empty(), 0, 0, read.obstacle().orElse("")));
      return;
    }
    Path file = folder.resolve(name(channel.topic()) + "." + format.extension());
    if (Files.exists(file)) {
      throw new IOException(file + " is there already: name a folder without such files after --out");
    }
    files.put(channel.id(), new TopicFile(channel, reading.get(), file, format.lines()));
  }

  private String name(String topic) {
    String plain = topic.replaceFirst("^/+", "").replaceAll("[^A-Za-z0-9._-]", "_");
    String bare = plain.isEmpty() || plain.startsWith(".") ? "topic" + plain : plain;
    String cut = bare.substring(0, Math.min(LONGEST_NAME, bare.length()));
    String name = cut;
    for (int number = 2; !names.add(name); number++) {
      name = cut + "_" + number;
    }
    return name;
  }

  private void write() throws IOException {
    try {
      Files.createDirectories(folder);
    } catch (FileAlreadyExistsException e) {
      throw new IOException(folder + " is a file; name a folder after --out", e);
    }
    boolean learns = format.lines().learns();
    if (learns) {
      each(message -> files.get(message.channel().id()).learn(message));
    }
    try {
      for (TopicFile file : files.values()) {
        file.begin();
      }
      long start = recording.span().map(RecordingInterval::start).orElse(0L);
      each(message -> files.get(message.channel().id()).write(message, start));
    } finally {
      for (TopicFile file : files.values()) {
        file.close();
      }
    }
  }

  @FunctionalInterface
  private interface Taking {
    void take(RecordedMessage message) throws IOException;
  }

  private void each(Taking taking) throws IOException {
    RecordingCursor cursor = recording.cursor(part.interval(), files.keySet());
    for (Optional<RecordedMessage> next = cursor.next(); next.isPresent(); next = cursor.next()) {
      taking.take(next.get());
    }
  }
}
