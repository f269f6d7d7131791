package org.robotui.recording;

import java.util.Map;

/**
 * What a recorder noted for the whole recording.
 *
 * @param name what these notes are about; several may have one name
 * @param values the notes
 */
public record RecordedMetadata(String name, Map<String, String> values) {

  /** As the components say; the notes are copied. */
  public RecordedMetadata {
    values = Map.copyOf(values);
  }
}
