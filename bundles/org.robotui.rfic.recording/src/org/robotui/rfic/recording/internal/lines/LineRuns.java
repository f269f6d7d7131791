package org.robotui.rfic.recording.internal.lines;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ObjLongConsumer;
import org.robotui.recording.MessageRuns;
import org.robotui.recording.RecordedChannel;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingDamage;
import org.robotui.recording.RecordingException;
import org.robotui.recording.ScanProgress;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The lines of a log in pieces of a megabyte. Filled by one thread, then read by any, one at a time. */
final class LineRuns implements MessageRuns {
  private static final Logger LOG = LoggerFactory.getLogger(LineRuns.class);
  private static final int BLOCK = 1 << 20;
  private static final int LONGEST = 1 << 20;
  private static final int MOST_DAMAGES = 1000;

  /** From the start of a line up to the end of another one. */
  private record Piece(long from, int length) {}

  private final Path file;
  private final LogBytes bytes;
  private final LineFormat format;
  private final List<Run> runs = new ArrayList<>();
  private final List<Piece> pieces = new ArrayList<>();
  private final List<RecordingDamage> damages = new ArrayList<>();

  LineRuns(Path file, LineFormat format) throws RecordingException {
    this.file = file;
    this.bytes = LogBytes.open(file);
    bytes.damage().ifPresent(damages::add);
    this.format = format;
  }

  /** Reads through all of it. */
  void scan(ScanProgress progress) throws RecordingException {
    try {
      RandomAccessFile in = bytes.in();
      long size = in.length();
      long at = 0;
      while (at < size) {
        byte[] block = bytes(in, at, (int) Math.min(BLOCK + LONGEST, size - at));
        int length = at + block.length == size && block.length <= BLOCK ? block.length : endOfLine(block);
        add(new Piece(at, length), block);
        at += length;
        progress.scanned(at, size);
      }
    } catch (IOException e) {
      throw new RecordingException(file, "cannot be read", e);
    }
  }

  private static byte[] bytes(RandomAccessFile in, long from, int length) throws IOException {
    byte[] bytes = new byte[length];
    in.seek(from);
    in.readFully(bytes);
    return bytes;
  }

  /** Behind the first line that ends beyond a block; all where it is too long to be one. */
  private static int endOfLine(byte[] bytes) {
    int at = Math.min(BLOCK, bytes.length) - 1;
    while (at < bytes.length && bytes[at] != '\n') {
      at++;
    }
    return Math.min(at + 1, bytes.length);
  }

  private void add(Piece piece, byte[] bytes) {
    long[] span = {Long.MAX_VALUE, Long.MIN_VALUE};
    Map<Integer, Long> counts = new HashMap<>();
    lines(piece, bytes, (line, place) -> {
      try {
        for (RecordedMessage message : format.messages(line)) {
          span[0] = Math.min(span[0], message.logTime());
          span[1] = Math.max(span[1], message.logTime());
          counts.merge(message.channel().id(), 1L, Long::sum);
        }
      } catch (IllegalArgumentException e) {
        damaged(place, "a line was left out: " + e.getMessage());
      }
    });
    if (!counts.isEmpty()) {
      pieces.add(piece);
      runs.add(new Run(span[0], span[1], counts));
    }
  }

  private static void lines(Piece piece, byte[] bytes, ObjLongConsumer<String> each) {
    int start = 0;
    for (int i = 0; i < piece.length(); i++) {
      if (bytes[i] == '\n' || i == piece.length() - 1) {
        int end = bytes[i] == '\n' ? i : i + 1;
        each.accept(new String(bytes, start, end - start, StandardCharsets.UTF_8).strip(), piece.from() + start);
        start = i + 1;
      }
    }
  }

  private void damaged(long place, String problem) {
    if (damages.size() < MOST_DAMAGES) {
      damages.add(new RecordingDamage(place, problem));
    }
  }

  @Override
  public Path file() {
    return file;
  }

  @Override
  public String format() {
    return format.name();
  }

  @Override
  public List<RecordedChannel> channels() {
    return format.channels();
  }

  @Override
  public List<Run> runs() {
    return List.copyOf(runs);
  }

  @Override
  public List<RecordedMessage> read(int run) throws RecordingException {
    Piece piece = pieces.get(run);
    List<RecordedMessage> messages = new ArrayList<>();
    try {
      lines(piece, bytes(bytes.in(), piece.from(), piece.length()), (line, place) -> {
        try {
          messages.addAll(format.messages(line));
        } catch (IllegalArgumentException e) {
          // told when the file was read through
          return;
        }
      });
      return messages;
    } catch (IOException e) {
      throw new RecordingException(file, "cannot be read any more", e);
    }
  }

  @Override
  public List<RecordingDamage> damages() {
    return List.copyOf(damages);
  }

  @Override
  public void close() {
    try {
      bytes.in().close();
    } catch (IOException e) {
      LOG.debug("{} is not closed", file, e);
    }
  }
}
