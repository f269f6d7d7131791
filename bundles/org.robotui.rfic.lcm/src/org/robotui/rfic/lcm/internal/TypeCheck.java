package org.robotui.rfic.lcm.internal;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Placed;
import org.robotui.api.config.SettingFault;
import org.robotui.data.Data;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.TypeFolder;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.rfic.lcm.internal.convert.CommandForm;
import org.robotui.rfic.lcm.internal.convert.CommandWriter;
import org.robotui.rfic.lcm.internal.language.FaultException;

/** Brings settings and types together. */
public final class TypeCheck {
  private static final int MOST_NAMED = 12;

  private TypeCheck() {}

  /** What is wrong with settings whose types are on this machine. */
  static List<SettingFault> faults(LcmSettings settings, Placed where) {
    TypeLibrary types;
    try {
      types = TypeFolder.read(settings.types());
    } catch (IOException e) {
      return List.of(
          where.fault("'types': " + e.getMessage() + "; write a file or folder of .lcm files, relative to this file"));
    }
    List<SettingFault> faults = new ArrayList<>();
    for (LcmSettings.Stream stream : settings.streams()) {
      stream.type().ifPresent(name -> attempt(faults, () -> stream.mapping().bind(type(name, types), types)));
    }
    for (LcmSettings.Command command : settings.commands()) {
      attempt(faults, () -> writer(command, command.form(), types));
    }
    return faults;
  }

  /** A part of the check. */
  @FunctionalInterface
  private interface Attempt {
    void run() throws FaultException;
  }

  private static void attempt(List<SettingFault> faults, Attempt attempt) {
    try {
      attempt.run();
    } catch (FaultException e) {
      faults.add(e.fault());
    }
  }

  /**
   * Finds the type that a configuration names.
   *
   * @param name the name, where it is written
   * @param types all types
   * @return the type
   * @throws FaultException where there is none
   */
  public static LcmType type(Placed name, TypeLibrary types) throws FaultException {
    Optional<LcmType> type = types.type(name.value().toString());
    return type.orElseThrow(() -> new FaultException(name.fault("no .lcm file declares the type '" + name.value()
        + "'; "
        + (types.types().isEmpty() ? "write after types: where the .lcm files are" : "there are " + names(types)))));
  }

  private static String names(TypeLibrary types) {
    List<String> names = types.types().stream().map(LcmType::name).sorted().toList();
    return names.size() <= MOST_NAMED ? String.join(", ", names)
        : String.join(", ", names.subList(0, MOST_NAMED)) + " and " + (names.size() - MOST_NAMED) + " more";
  }

  /**
   * Makes what writes commands.
   *
   * @param <D> the kind of commands
   * @param command what the configuration says
   * @param form the kind of commands
   * @param types all types
   * @return the writer
   * @throws FaultException where members are not there or cannot hold what they shall
   */
  public static <D extends Data> CommandWriter<D> writer(LcmSettings.Command command, CommandForm<D> form,
      TypeLibrary types)
      throws FaultException {
    LcmType type = type(command.type(), types);
    try {
      return new CommandWriter<>(form, command.mapping().bind(type, types), (Map<?, ?>) command.fixed().value(), type,
          types);
    } catch (IllegalArgumentException e) {
      Placed at = command.fixed().line() > 0 ? command.fixed() : command.mapping().place();
      throw new FaultException(at.fault(command.mapping().channel() + ": " + e.getMessage()));
    }
  }
}
