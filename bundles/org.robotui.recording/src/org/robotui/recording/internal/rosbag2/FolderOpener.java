package org.robotui.recording.internal.rosbag2;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.robotui.recording.RecordedMetadata;
import org.robotui.recording.RecordingException;
import org.robotui.recording.ScanProgress;
import org.robotui.recording.internal.chunk.DamageList;
import org.robotui.recording.internal.chunk.JoinedRecordings;
import org.robotui.recording.internal.chunk.MessageUnpacking;
import org.robotui.recording.internal.chunk.OpenedRecording;
import org.robotui.recording.internal.io.FileBytes;

/** Opens folders of rosbag2, and files that they may consist of. */
public final class FolderOpener {

  private static final String FORMAT = "rosbag2";
  private static final Pattern PART = Pattern.compile("(.*)_\\d+\\.(?:db3|mcap)(?:\\.zstd)?");

  private final PartOpener plain;

  /** Opens files that are not compressed. */
  @FunctionalInterface
  public interface PartOpener {
    /** What the file is, which is closed where that fails. */
    OpenedRecording open(FileBytes file, ScanProgress progress) throws RecordingException;
  }

  /**
   * @param plain opens a file of a folder by what it begins with
   */
  public FolderOpener(PartOpener plain) {
    this.plain = plain;
  }

  /** Whether a path stands for a folder of rosbag2: the folder itself, or the file in it that describes it. */
  public static Optional<Path> folder(Path path) throws RecordingException {
    if (path.endsWith(BagMetadata.NAME) && Files.isRegularFile(path)) {
      return Optional.of(path.toAbsolutePath().getParent());
    }
    return Files.isDirectory(path) && (Files.exists(path.resolve(BagMetadata.NAME)) || !names(path).isEmpty())
        ? Optional.of(path)
        : Optional.empty();
  }

  /** Whether a file is compressed as a whole, as recorders of rosbag2 do it. */
  public static boolean isPacked(FileBytes file) throws RecordingException {
    return UnpackedFile.isPacked(file);
  }

  /** What a recorder that was killed has left has no description: files of one name with a number. */
  private static List<String> names(Path folder) throws RecordingException {
    try (Stream<Path> all = Files.list(folder)) {
      List<String> names = all.map(each -> each.getFileName().toString()).filter(name -> PART.matcher(name).matches())
          .sorted().toList();
      return names.stream().map(name -> PART.matcher(name).replaceFirst("$1")).distinct().count() == 1 ? names
          : List.of();
    } catch (IOException e) {
      throw new RecordingException(folder, "cannot be looked into", e);
    }
  }

  /** Opens all files of a folder as one recording. */
  public OpenedRecording open(Path folder, ScanProgress progress) throws RecordingException {
    DamageList damages = new DamageList();
    Optional<BagMetadata> metadata = metadata(folder, damages);
    List<String> described = metadata.map(BagMetadata::files).orElse(List.of());
    List<String> names = described.isEmpty() ? names(folder) : described;
    List<OpenedRecording> parts = new ArrayList<>();
    boolean opened = false;
    try {
      for (int i = 0; i < names.size(); i++) {
        part(folder.resolve(names.get(i)), new PartProgress(progress, i, names.size()), parts, damages);
      }
      if (parts.isEmpty()) {
        throw new RecordingException(folder, 0, "no file of this recording can be read"
            + damages.all().stream().findFirst().map(each -> ": " + each.problem()).orElse(""));
      }
      opened = true;
      return joined(folder, parts, metadata, damages);
    } finally {
      if (!opened) {
        parts.forEach(each -> each.end().run());
      }
    }
  }

  private static Optional<BagMetadata> metadata(Path folder, DamageList damages) {
    try {
      Optional<BagMetadata> metadata = BagMetadata.of(folder);
      if (metadata.isEmpty()) {
        damages.add(0, "there is no " + BagMetadata.NAME + ", as the recorder was killed: all files of the folder were"
            + " taken");
      }
      return metadata;
    } catch (RecordingException e) {
      damages.add(0, "all files of the folder were taken: " + e.getMessage());
      return Optional.empty();
    }
  }

  private void part(Path file, ScanProgress progress, List<OpenedRecording> parts, DamageList damages) {
    try {
      parts.add(opened(file, damages, progress));
    } catch (RecordingException e) {
      damages.add(0, "a file of the recording was left out: " + e.getMessage());
    }
  }

  private OpenedRecording opened(Path file, DamageList damages, ScanProgress progress) throws RecordingException {
    FileBytes bytes = FileBytes.open(file);
    boolean opened = false;
    try {
      if (UnpackedFile.isPacked(bytes)) {
        bytes.close();
        Path room = Path.of(System.getProperty("java.io.tmpdir"));
        bytes = UnpackedFile.of(file, room, damages, progress);
      }
      OpenedRecording recording = plain.open(bytes, progress);
      opened = true;
      return recording;
    } finally {
      if (!opened) {
        bytes.close();
      }
    }
  }

  private static OpenedRecording joined(Path folder, List<OpenedRecording> parts, Optional<BagMetadata> metadata,
      DamageList damages) {
    metadata.filter(known -> !known.notes().isEmpty())
        .ifPresent(known -> parts.getFirst().index().metadata().add(new RecordedMetadata(FORMAT, known.notes())));
    Optional<MessageUnpacking> unpacking =
        metadata.filter(BagMetadata::perMessage).map(known -> new MessageUnpacking());
    return JoinedRecordings.join(folder, FORMAT + " " + parts.getFirst().format().replace(FORMAT + " ", ""), parts,
        damages, unpacking);
  }

  /** Opens one file alone; what a description beside it says of its messages counts. */
  public OpenedRecording openAlone(Path file, ScanProgress progress) throws RecordingException {
    DamageList damages = new DamageList();
    Path folder = file.toAbsolutePath().getParent();
    OpenedRecording part = opened(file, damages, progress);
    Optional<MessageUnpacking> unpacking = messagesOf(file, folder);
    return unpacking.isEmpty() && damages.all().isEmpty() ? part
        : JoinedRecordings.join(file, part.format(), List.of(part), damages, unpacking);
  }

  private static Optional<MessageUnpacking> messagesOf(Path file, Path folder) {
    try {
      return BagMetadata.of(folder)
          .filter(known -> known.perMessage() && known.files().contains(file.getFileName().toString()))
          .map(known -> new MessageUnpacking());
    } catch (RecordingException e) {
      return Optional.empty(); // the file is one without it
    }
  }

  /** How far all files are while one of them is read. */
  private record PartProgress(ScanProgress all, int part, int parts) implements ScanProgress {
    @Override
    public void scanned(long done, long size) {
      all.scanned(part * size + done, parts * size);
    }
  }
}
