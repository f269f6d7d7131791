package org.robotui.rfic.recording.internal;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.SettingFault;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.message.topic.TopicSettings;
import org.robotui.recording.RecordingException;
import org.robotui.rfic.recording.internal.file.RecordingFiles;
import org.robotui.rfic.recording.internal.time.PlaySettings;

/**
 * Which recording is played, and how.
 *
 * @param file the recording
 * @param types where types of LCM are declared: files and folders
 * @param topics which topics become ports
 * @param playing how it comes to the timeline
 */
public record RecordingSettings(Path file, List<Path> types, TopicSettings topics, PlaySettings playing) {
  static final String FILE = "file";
  private static final String TYPES = "types";
  private static final String OFFSET = "offset";
  private static final String PLAY = "play";
  private static final String LOOP = "loop";
  private static final double FARTHEST_SECONDS = 4e9;
  private static final double NANOS = 1e9;
  private static final int LONGEST = 1000;

  static final Schema SCHEMA = schema();

  private static Schema schema() {
    List<Setting> all = new ArrayList<>();
    all.add(Setting.required(FILE, new ValueType.WithPlace(new ValueType.Text()),
        "the recording, MCAP, a bag of ROS 1, a folder or file of rosbag2 or a log of LCM, CARMEN or Player, relative to this file"));
    all.add(Setting.optional(TYPES,
        new ValueType.WithPlace(new ValueType.AnyOf(
            List.of(new ValueType.Text(), new ValueType.ListOf(new ValueType.Text())))),
        "for logs of LCM: files and folders of .lcm files, relative to this file"));
    all.addAll(TopicSettings.listening(RecordingSettings::checkName));
    all.add(Setting.of(OFFSET, new ValueType.Num(-FARTHEST_SECONDS, FARTHEST_SECONDS, "s"), 0.0,
        "what is added to its times, where it is shown beside recordings of other clocks"));
    all.add(Setting.of(PLAY, new ValueType.Flag(), true, "whether it plays as soon as it is open"));
    all.add(Setting.of(LOOP, new ValueType.Flag(), false, "whether it begins again at its end"));
    return new Schema(all);
  }

  static RecordingSettings of(Settings settings) {
    Placed written = settings.placed(FILE);
    return new RecordingSettings(written.resolve(written.value().toString()), types(settings),
        TopicSettings.ofListening(settings),
        new PlaySettings(Math.round(settings.number(OFFSET) * NANOS), settings.flag(PLAY), settings.flag(LOOP)));
  }

  private static List<Path> types(Settings settings) {
    return settings.has(TYPES) ? places(settings.placed(TYPES)).map(settings.placed(TYPES)::resolve).toList()
        : List.of();
  }

  private static Stream<String> places(Placed written) {
    return written.value() instanceof List<?> list ? list.stream().map(Object::toString)
        : Stream.of(written.value().toString());
  }

  /** What is wrong with the files. The beginning of the recording is read. */
  static List<SettingFault> faults(Settings settings) {
    List<SettingFault> faults = new ArrayList<>();
    Placed written = settings.placed(FILE);
    fault(written).ifPresent(
        reason -> faults.add(written.fault("'" + FILE + "': " + written.value() + " " + reason)));
    if (settings.has(TYPES)) {
      Placed types = settings.placed(TYPES);
      places(types).filter(place -> !isThere(types, place)).forEach(place -> faults.add(types.fault("'" + TYPES + "': "
          + place + " is not there; write where .lcm files are, relative to this file")));
    }
    return faults;
  }

  private static boolean isThere(Placed written, String place) {
    try {
      return Files.exists(written.resolve(place));
    } catch (InvalidPathException e) {
      return false;
    }
  }

  private static Optional<String> fault(Placed written) {
    Path file;
    try {
      file = written.resolve(written.value().toString());
    } catch (InvalidPathException e) {
      return Optional.of("is no name of a file: " + e.getReason());
    }
    if (!Files.exists(file)) {
      return Optional.of("is not there; write where the recording is, relative to this file");
    }
    boolean folder = Files.isDirectory(file);
    if (!folder && !Files.isRegularFile(file)) {
      return Optional.of("is a device or a pipe; name a file");
    }
    if (!Files.isReadable(file)) {
      return Optional.of("may not be read: permission denied");
    }
    try {
      return RecordingFiles.isOne(file) ? Optional.empty()
          : Optional.of("is no " + (folder ? "folder of rosbag2; name one, or a file" : "recording that is known here")
              + "; " + RecordingFiles.KNOWN + " are");
    } catch (RecordingException e) {
      return Optional.of("cannot be read: " + e.getMessage());
    }
  }

  /** What is no recording of ROS names its topics as it likes. */
  private static void checkName(String name) {
    if (name.isBlank() || name.length() > LONGEST || name.chars().anyMatch(Character::isISOControl)) {
      throw new IllegalArgumentException("a name has from 1 to " + LONGEST + " characters, none of them for control");
    }
  }
}
