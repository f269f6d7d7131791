package org.robotui.uic.teleop.internal;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Optional;
import java.util.stream.StreamSupport;

/** Finds the file of a gamepad. */
final class PadDevice {
  private static final Path FOLDER = Path.of("/dev/input");

  private PadDevice() {}

  /** The device of a mapping, where it is there now. */
  static Optional<Path> find(PadMapping mapping) {
    return mapping.device().equals(PadMapping.AUTO) ? first(FOLDER)
        : Optional.of(Path.of(mapping.device())).filter(Files::exists);
  }

  /** The joystick of the lowest number in a folder. */
  static Optional<Path> first(Path folder) {
    try (DirectoryStream<Path> devices = Files.newDirectoryStream(folder, "js*")) {
      return StreamSupport.stream(devices.spliterator(), false)
          .filter(device -> device.getFileName().toString().matches("js\\d{1,4}"))
          .min(Comparator.comparingInt(device -> Integer.parseInt(device.getFileName().toString().substring(2))));
    } catch (IOException e) {
      return Optional.empty(); // no such folder: there are no input devices at all
    }
  }
}
