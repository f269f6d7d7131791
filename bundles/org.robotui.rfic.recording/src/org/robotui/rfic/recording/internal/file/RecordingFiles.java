package org.robotui.rfic.recording.internal.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.robotui.lcm.log.LcmRecording;
import org.robotui.lcm.type.TypeFolder;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingReader;
import org.robotui.recording.Recordings;
import org.robotui.recording.ScanProgress;
import org.robotui.rfic.recording.internal.lines.LineLogs;

/** Opens recordings of any framework. */
public final class RecordingFiles {
  /** What can be opened, for users. */
  public static final String KNOWN = Recordings.KNOWN + ", logs of LCM, and " + LineLogs.KNOWN;

  private RecordingFiles() {}

  /**
   * Whether something is a recording, by what it begins with.
   *
   * @param file a file or folder
   * @return true where it would be opened
   * @throws RecordingException if it cannot be read
   */
  public static boolean isOne(Path file) throws RecordingException {
    return Recordings.isOne(file) || LcmRecording.isOne(file) || LineLogs.isOne(file);
  }

  /**
   * Opens a recording.
   *
   * @param file a file or folder
   * @param types files and folders of declarations of LCM; what is wrong in them is left out
   * @param progress hears how far one without an index is
   * @return the recording; who opens it closes it
   * @throws IOException if it cannot be read, or types are not there
   */
  public static RecordingReader open(Path file, List<Path> types, ScanProgress progress) throws IOException {
    if (LineLogs.isOne(file)) {
      return LineLogs.open(file, progress);
    }
    return LcmRecording.isOne(file) ? LcmRecording.open(file, types(types), progress)
        : Recordings.open(file, progress);
  }

  /**
   * Opens a recording to send it into its framework: what is a log of a framework has its own messages, where it is
   * otherwise read as messages of ROS 1.
   *
   * @param file a file or folder
   * @param types files and folders of declarations of LCM; what is wrong in them is left out
   * @param progress hears how far one without an index is
   * @return the recording; who opens it closes it
   * @throws IOException if it cannot be read, or types are not there
   */
  public static RecordingReader openToSend(Path file, List<Path> types, ScanProgress progress) throws IOException {
    return LineLogs.isOne(file) ? LineLogs.openToSend(file, progress) : open(file, types, progress);
  }

  private static TypeLibrary types(List<Path> places) throws IOException {
    return places.isEmpty() ? TypeLibrary.of(List.of(), List.of()) : TypeFolder.read(places);
  }
}
