package org.robotui.rfic.xbot.internal;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.data.control.Drives;
import org.robotui.data.control.Drives.Drive;
import org.robotui.data.control.Drives.Phase;

/** What the supervisor answers of the drives: a line each of phase, joint and detail, with tabs between. */
final class DriveReader {
  private static final int FIELDS = 3;

  private DriveReader() {}

  /** Lines that say something else are left out. */
  static Drives read(String text) {
    return new Drives(text.lines().map(line -> line.split("\t", FIELDS)).filter(fields -> fields.length == FIELDS)
        .flatMap(fields -> phase(fields[0]).map(phase -> new Drive(fields[1], phase, fields[2])).stream()).toList());
  }

  private static Optional<Phase> phase(String word) {
    return Stream.of(Phase.values()).filter(phase -> phase.name().toLowerCase(Locale.ROOT).equals(word)).findFirst();
  }

  /** Which drives do not obey because they are off, where no other one is missing. */
  static Optional<String> off(Drives drives) {
    List<Drive> idle = drives.drives().stream().filter(drive -> drive.phase() != Phase.ENABLED).toList();
    boolean known = idle.stream().allMatch(d -> d.phase() == Phase.DISABLED || d.phase() == Phase.ENABLING);
    if (idle.isEmpty() || !known) {
      return Optional.empty();
    }
    return Optional.of("drives are not enabled: " + idle.stream().map(Drive::joint).collect(Collectors.joining(", ")));
  }
}
