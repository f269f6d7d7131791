package org.robotui.recording;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.robotui.recording.internal.bag.BagOpener;
import org.robotui.recording.internal.bag.OldBagOpener;
import org.robotui.recording.internal.chunk.ChunkedRecording;
import org.robotui.recording.internal.chunk.OpenedRecording;
import org.robotui.recording.internal.chunk.RunSource;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.mcap.McapOpener;
import org.robotui.recording.internal.rosbag2.DatabaseOpener;
import org.robotui.recording.internal.rosbag2.FolderOpener;
import org.robotui.recording.internal.sqlite.SqlitePages;

/** Opens recordings of any format that is known here. Any thread may use it. */
public final class Recordings {

  /** What can be opened, in words for users. */
  public static final String KNOWN =
      "MCAP, bags of ROS 1 (version 1.2 and 2.0), and folders and databases (.db3) of rosbag2";

  private Recordings() {}

  /**
   * Opens a file by what it begins with; its name does not matter. A folder of rosbag2 is opened with all its files,
   * also by the {@code metadata.yaml} in it. A file with an index is open at once; any other is read through first,
   * which is said by {@link RecordingReader#isIndexed}. Damaged files are opened too. A file that is compressed as a
   * whole is decompressed into the folder for temporary files, and takes its room there until it is closed.
   *
   * @param file the recording
   * @param progress hears how far a file without an index is
   * @return the recording; who opens it closes it
   * @throws RecordingException if it cannot be read, or is of none of the formats
   */
  public static RecordingReader open(Path file, ScanProgress progress) throws RecordingException {
    FolderOpener opener = new FolderOpener(Recordings::open);
    Optional<Path> folder = FolderOpener.folder(file);
    if (folder.isEmpty() && Files.isDirectory(file)) {
      throw new RecordingException(file, 0, "this folder has neither a metadata.yaml nor files of rosbag2");
    }
    return new ChunkedRecording(
        folder.isPresent() ? opener.open(folder.get(), progress) : opener.openAlone(file, progress));
  }

  /**
   * Whether a file is of one of the formats, by what it begins with; whether a folder is one of rosbag2.
   *
   * @param file any file or folder
   * @return true where {@link #open} would try to read it
   * @throws RecordingException if it cannot be read
   */
  public static boolean isOne(Path file) throws RecordingException {
    boolean folder = FolderOpener.folder(file).isPresent();
    if (folder || Files.isDirectory(file)) {
      return folder;
    }
    FileBytes bytes = FileBytes.open(file);
    try {
      return McapOpener.isOne(bytes) || BagOpener.isOne(bytes) || OldBagOpener.isOne(bytes) || SqlitePages.isOne(bytes)
          || FolderOpener.isPacked(bytes);
    } finally {
      bytes.close();
    }
  }

  /**
   * A recording of a format that is not known here.
   *
   * @param runs what is in it; closed with the recording
   * @return the recording; who makes it closes it
   */
  public static RecordingReader of(MessageRuns runs) {
    return new ChunkedRecording(RunSource.open(runs));
  }

  private static OpenedRecording open(FileBytes bytes, ScanProgress progress) throws RecordingException {
    if (McapOpener.isOne(bytes)) {
      return McapOpener.open(bytes, progress);
    }
    if (BagOpener.isOne(bytes)) {
      return BagOpener.open(bytes, progress);
    }
    if (OldBagOpener.isOne(bytes)) {
      return OldBagOpener.open(bytes, progress);
    }
    if (SqlitePages.isOne(bytes)) {
      return DatabaseOpener.open(bytes, progress);
    }
    throw new RecordingException(bytes.path(), 0, "this is no recording that is known here: " + KNOWN + " are");
  }
}
