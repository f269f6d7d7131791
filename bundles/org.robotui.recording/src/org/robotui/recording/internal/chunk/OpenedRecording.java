package org.robotui.recording.internal.chunk;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import org.robotui.recording.RecordingDamage;
import org.robotui.recording.internal.io.FileBytes;

/**
 * What a format knows of a recording that was opened.
 *
 * @param path as it was opened
 * @param format its name
 * @param indexed whether it was not read through
 * @param index what is in it
 * @param source reads its chunks
 * @param damages what could not be read so far
 * @param end closes it
 */
public record OpenedRecording(Path path, String format, boolean indexed, FileIndex index, ChunkSource source,
    Supplier<List<RecordingDamage>> damages, Runnable end) {

  /** One that is a file. */
  public static OpenedRecording of(FileBytes file, String format, boolean indexed, FileIndex index,
      ChunkSource source, DamageList damages) {
    return new OpenedRecording(file.path(), format, indexed, index, source, damages::all, file::close);
  }
}
