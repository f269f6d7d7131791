package org.robotui.recording.internal.rosbag2;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.recording.RecordingException;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;
import org.yaml.snakeyaml.error.YAMLException;

/**
 * What {@code metadata.yaml} says of a folder.
 *
 * @param files names of the files of the recording, which lie beside it
 * @param perMessage whether each message is compressed
 * @param notes what else it says of all of it
 */
record BagMetadata(List<String> files, boolean perMessage, Map<String, String> notes) {

  static final String NAME = "metadata.yaml";
  private static final long MOST_BYTES = 64 << 20;
  private static final String ROOT = "rosbag2_bagfile_information";

  /** Where there is none, files are what the folder has. */
  static Optional<BagMetadata> of(Path folder) throws RecordingException {
    Path file = folder.resolve(NAME);
    if (!Files.exists(file)) {
      return Optional.empty();
    }
    try {
      if (Files.size(file) > MOST_BYTES) {
        throw new RecordingException(file, MOST_BYTES, "it is longer than what is read of it");
      }
      LoaderOptions options = new LoaderOptions();
      options.setCodePointLimit((int) MOST_BYTES);
      Object tree = new Yaml(new SafeConstructor(options)).load(Files.readString(file));
      if (tree instanceof Map<?, ?> root && root.get(ROOT) instanceof Map<?, ?> known) {
        return Optional.of(of(known));
      }
      throw new RecordingException(file, 0, "it has no '" + ROOT + "', so that it is not of a recording of rosbag2");
    } catch (YAMLException e) {
      throw new RecordingException(file, 0,
          "it is no YAML that can be read: " + e.getMessage().replaceAll("\\s+", " "));
    } catch (RecordingException e) {
      throw e;
    } catch (IOException e) {
      throw new RecordingException(file, "cannot be read", e);
    }
  }

  private static BagMetadata of(Map<?, ?> known) {
    // the first versions wrote the folder before the name; parts never lie elsewhere
    List<String> files = known.get("relative_file_paths") instanceof List<?> list
        ? list.stream().map(each -> String.valueOf(each).replaceFirst(".*/", "")).filter(name -> !name.isBlank())
            .toList()
        : List.of();
    Map<String, String> notes = new LinkedHashMap<>();
    for (String name : List.of("version", "storage_identifier", "ros_distro", "compression_format",
        "compression_mode")) {
      note(notes, name, known.get(name));
    }
    if (known.get("custom_data") instanceof Map<?, ?> custom) {
      custom.forEach((key, value) -> note(notes, String.valueOf(key), value));
    }
    return new BagMetadata(files, "MESSAGE".equalsIgnoreCase(String.valueOf(known.get("compression_mode"))), notes);
  }

  private static void note(Map<String, String> notes, String name, Object value) {
    if (value != null && !value.toString().isEmpty()) {
      notes.put(name, value.toString());
    }
  }
}
