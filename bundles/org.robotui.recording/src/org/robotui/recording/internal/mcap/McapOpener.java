package org.robotui.recording.internal.mcap;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalLong;
import org.robotui.recording.RecordingException;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.chunk.OpenedRecording;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;

/** Opens MCAP files, by their summary or by reading through them. */
public final class McapOpener {

  private static final String FORMAT = "mcap";

  private McapOpener() {}

  /** Whether a file is one, by its first bytes. */
  public static boolean isOne(FileBytes file) throws RecordingException {
    byte[] magic = McapFormat.magic();
    return file.size() >= magic.length && Arrays.equals(file.read(0, magic.length), magic);
  }

  public static OpenedRecording open(FileBytes file, ScanProgress progress) throws RecordingException {
    DamageList damages = new DamageList();
    Optional<McapSummary> summary = summary(file, damages);
    if (summary.isPresent()) {
      McapSource source = new McapSource(file, summary.get().definitions(), damages);
      return OpenedRecording.of(file, FORMAT, true, summary.get().index(), source, damages);
    }
    McapScan scan = new McapScan(file, damages);
    scan.run(progress);
    return OpenedRecording.of(file, FORMAT, false, scan.index(), scan.source(), damages);
  }

  /** A file need not have a summary, nor one with all that is needed: only a wrong one is a damage. */
  private static Optional<McapSummary> summary(FileBytes file, DamageList damages) throws RecordingException {
    McapSummary summary = new McapSummary(file);
    try {
      OptionalLong start = summary.start();
      return start.isPresent() && summary.read(start.getAsLong()) ? Optional.of(summary) : Optional.empty();
    } catch (MalformedRecord e) {
      damages.add(file.size(), "the summary cannot be used, so that the file was read through: " + e.getMessage());
      return Optional.empty();
    }
  }
}
