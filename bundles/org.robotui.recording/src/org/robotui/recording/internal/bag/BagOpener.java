package org.robotui.recording.internal.bag;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import org.robotui.recording.RecordingException;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.chunk.OpenedRecording;
import org.robotui.recording.internal.io.ByteWindow;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;

/** Opens bags of ROS 1, by their index or by reading through them. */
public final class BagOpener {

  private static final String FORMAT = "rosbag 2.0";
  static final byte[] MAGIC = "#ROSBAG V2.0\n".getBytes(StandardCharsets.US_ASCII);

  private BagOpener() {}

  /** Whether a file is one, by its first bytes. */
  public static boolean isOne(FileBytes file) throws RecordingException {
    return file.size() >= MAGIC.length && Arrays.equals(file.read(0, MAGIC.length), MAGIC);
  }

  public static OpenedRecording open(FileBytes file, ScanProgress progress) throws RecordingException {
    DamageList damages = new DamageList();
    Optional<BagIndex> index = index(file, damages);
    if (index.isPresent()) {
      BagSource source = new BagSource(file, index.get().connections(), damages);
      return OpenedRecording.of(file, FORMAT, true, index.get().index(), source, damages);
    }
    BagScan scan = new BagScan(file, damages);
    scan.run(MAGIC.length, progress);
    return OpenedRecording.of(file, FORMAT, false, scan.index(), scan.source(), damages);
  }

  /** Empty where there is none that can be used. A bag that was not finished says so, which is no damage of its own. */
  private static Optional<BagIndex> index(FileBytes file, DamageList damages) throws RecordingException {
    try {
      BagRecord bag = BagRecord.at(MAGIC.length, file, ByteWindow.small(file));
      if (bag.header().op() != BagFields.BAG) {
        throw new MalformedRecord("the bag does not begin with its header");
      }
      if (bag.header().size("index_pos") == 0) {
        damages.add(MAGIC.length, "the bag was not finished, so that it was read through");
        return Optional.empty();
      }
      BagIndex index = new BagIndex(file);
      index.read(bag.header(), MAGIC.length);
      return Optional.of(index);
    } catch (MalformedRecord e) {
      damages.add(MAGIC.length, "the index cannot be used, so that the file was read through: " + e.getMessage());
      return Optional.empty();
    }
  }
}
