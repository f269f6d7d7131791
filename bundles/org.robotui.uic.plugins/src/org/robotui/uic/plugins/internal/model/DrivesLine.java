package org.robotui.uic.plugins.internal.model;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.data.control.Drives;
import org.robotui.data.control.Drives.Drive;
import org.robotui.data.control.Drives.Phase;
import org.robotui.data.control.Histogram;
import org.robotui.ui.Health;

/**
 * The drives of the joints, as one line below the thread of the hardware.
 *
 * @param drives each of them, at least one
 * @param pending whether the control was asked something that it has not answered yet
 */
public record DrivesLine(List<Drive> drives, boolean pending) implements Line {
  /** By which what was asked of drives is told from what was asked of plugins. */
  public static final String ALL = "";

  private static final List<Phase> WORST_FIRST =
      List.of(Phase.FAULT, Phase.SILENT, Phase.ENABLING, Phase.DISABLED, Phase.ENABLED);

  /** Copies the list. */
  public DrivesLine {
    drives = List.copyOf(drives);
  }

  /** The line, where the hardware has drives at all. */
  static Optional<DrivesLine> of(Drives told, boolean pending) {
    return Optional.of(told.drives()).filter(drives -> !drives.isEmpty())
        .map(drives -> new DrivesLine(drives, pending));
  }

  @Override
  public String key() {
    return "drives";
  }

  @Override
  public String name() {
    return "Drives";
  }

  @Override
  public Health health() {
    return switch (worst()) {
      case FAULT, SILENT -> Health.BAD;
      case ENABLING -> Health.WAITING;
      case DISABLED -> Health.NONE;
      case ENABLED -> Health.OK;
    };
  }

  private Phase worst() {
    return WORST_FIRST.stream().filter(this::has).findFirst().orElse(Phase.ENABLED);
  }

  /** Whether one of them is there. */
  public boolean has(Phase phase) {
    return drives.stream().anyMatch(drive -> drive.phase() == phase);
  }

  @Override
  public String word() {
    return word(worst());
  }

  private static String word(Phase phase) {
    return phase.name().toLowerCase(Locale.ROOT);
  }

  @Override
  public String words() {
    return drives.stream().filter(drive -> isBad(drive.phase())).findFirst().map(DrivesLine::sentence)
        .orElseGet(this::counted);
  }

  /** How many are where, the worst first; those that are off by name. */
  public String counted() {
    return WORST_FIRST.stream().filter(this::has).map(this::counted).collect(Collectors.joining(" \u00b7 "));
  }

  private String counted(Phase phase) {
    List<String> joints = drives.stream().filter(d -> d.phase() == phase).map(Drive::joint).toList();
    String count = joints.size() + " " + (phase == Phase.FAULT ? "in " : "") + word(phase);
    return phase == Phase.ENABLED || joints.size() == drives.size() ? count : count + ": " + String.join(", ", joints);
  }

  /** What is wrong, a line each; empty where nothing is. */
  public String problem() {
    return drives.stream().filter(drive -> isBad(drive.phase())).map(DrivesLine::sentence)
        .collect(Collectors.joining("\n"));
  }

  private static boolean isBad(Phase phase) {
    return phase == Phase.FAULT || phase == Phase.SILENT;
  }

  private static String sentence(Drive drive) {
    return Stream.of(drive.joint() + ": " + word(drive.phase()), drive.detail()).filter(part -> !part.isBlank())
        .collect(Collectors.joining(", "));
  }

  @Override
  public Evidence busy() {
    return Evidence.of(new Histogram(List.of(), List.of(), 0), Optional.empty());
  }

  @Override
  public long period() {
    return 0;
  }
}
