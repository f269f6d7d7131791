package org.robotui.recording.internal.bag;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.robotui.recording.RecordingException;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.chunk.FileIndex;
import org.robotui.recording.internal.chunk.OpenedRecording;
import org.robotui.recording.internal.io.ByteWindow;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;

/**
 * Opens bags of ROS 1 of version 1.2, which have no chunks: definitions and messages lie one after another. They are
 * read through, whether they have an index or not.
 */
public final class OldBagOpener {

  private static final String FORMAT = "rosbag 1.2";
  private static final List<byte[]> MAGICS = List.of("#ROSRECORD V1.2\n".getBytes(StandardCharsets.US_ASCII),
      "#ROSBAG V1.2\n".getBytes(StandardCharsets.US_ASCII));
  /** Messages are read in pieces of so many bytes, but for longer ones. */
  private static final int PIECE = 1 << 20;
  /** Names of topics and of types come before the kind of a message. */
  private static final int FARTHEST_KIND = 1024;

  private final FileBytes file;
  private final ByteWindow window;
  private final RecordFinder finder;
  private final DamageList damages = new DamageList();
  private final FileIndex index = new FileIndex();
  private final OldBagSource source;

  private OldBagOpener(FileBytes file) {
    this.file = file;
    window = new ByteWindow(file);
    finder = new RecordFinder(file, window, BagFields.MESSAGE, FARTHEST_KIND);
    source = new OldBagSource(file, index.channels(), damages);
  }

  /** Whether a file is one, by its first bytes. */
  public static boolean isOne(FileBytes file) throws RecordingException {
    return magic(file).isPresent();
  }

  private static Optional<byte[]> magic(FileBytes file) throws RecordingException {
    for (byte[] each : MAGICS) {
      if (file.size() >= each.length && Arrays.equals(file.read(0, each.length), each)) {
        return Optional.of(each);
      }
    }
    return Optional.empty();
  }

  public static OpenedRecording open(FileBytes file, ScanProgress progress) throws RecordingException {
    OldBagOpener opener = new OldBagOpener(file);
    opener.scan(magic(file).map(each -> each.length).orElse(0), progress);
    return OpenedRecording.of(file, FORMAT, false, opener.index, opener.source, opener.damages);
  }

  private void scan(long first, ScanProgress progress) throws RecordingException {
    long at = first;
    while (at < file.size()) {
      long end = endOfPiece(at);
      if (end > at) {
        index.scanned(at, end - at, source.load(at, (int) (end - at)));
        at = end;
      } else {
        long next = finder.next(at + 1, this::isMessage);
        damages.add(at, "there is no whole record, so that " + (next - at) + " bytes were left out");
        at = next;
      }
      progress.scanned(at, file.size());
    }
    source.complete();
  }

  /** Behind the last record that is whole and lies in a piece from there; the same place where there is none. */
  private long endOfPiece(long from) throws RecordingException {
    long at = from;
    while (at < file.size()) {
      long end = endOfRecord(at);
      if (end < 0 || end - from > PIECE && at > from) {
        return at;
      }
      at = end;
    }
    return at;
  }

  private long endOfRecord(long at) throws RecordingException {
    long left = file.size() - at;
    long header = left < 2 * Integer.BYTES ? -1 : window.u32(at);
    if (header < 0 || header > BagFields.MOST_HEADER || header > left - 2 * Integer.BYTES) {
      return -1;
    }
    long data = at + Integer.BYTES + header;
    long end = data + Integer.BYTES + window.u32(data);
    return end > file.size() || end - at > OldBagSource.MOST_BYTES ? -1 : end;
  }

  private boolean isMessage(long place) throws RecordingException {
    if (endOfRecord(place) < 0) {
      return false;
    }
    try {
      BagFields header = BagRecord.at(place, file, window).header();
      return header.op() == BagFields.MESSAGE && header.text("topic").isPresent() && header.text("type").isPresent();
    } catch (MalformedRecord e) {
      return false;
    }
  }
}
