package org.robotui.workbench.internal.rcp;

import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.core.commands.Command;
import org.eclipse.core.commands.IParameter;
import org.eclipse.core.commands.ParameterizedCommand;
import org.eclipse.core.commands.common.NotDefinedException;
import org.eclipse.jface.bindings.Binding;
import org.eclipse.jface.bindings.keys.KeySequence;
import org.eclipse.ui.commands.ICommandService;
import org.eclipse.ui.keys.IBindingService;
import org.eclipse.ui.services.IServiceLocator;
import org.robotui.workbench.internal.keys.KeyRules;
import org.robotui.workbench.internal.keys.KeyedCommand;

/**
 * The commands of the platform that users of RobotUI meet: all that we and other plug-ins bring, and those few of the
 * platform that stand in our menus. Most of its own are for editors and perspectives, which are not here.
 */
final class CommandCatalog {
  /** Where keys hold: in windows, not in dialogs. */
  static final String CONTEXT = "org.eclipse.ui.contexts.window";

  private static final String OWN = "org.robotui.workbench.";
  private static final String STOP = OWN + "command.stop";
  private static final String PLATFORM = "org.eclipse.";
  private static final List<String> OF_PLATFORM = List.of("org.eclipse.ui.file.exit", "org.eclipse.ui.window.newWindow",
      "org.eclipse.ui.window.preferences", "org.eclipse.ui.help.aboutAction", "org.eclipse.ui.window.quickAccess");

  private final ICommandService commands;
  private final IBindingService bindings;

  CommandCatalog(IServiceLocator locator) {
    commands = locator.getService(ICommandService.class);
    bindings = locator.getService(IBindingService.class);
  }

  /** All commands that there are now, by name. */
  Map<KeyedCommand, ParameterizedCommand> all() {
    Map<ParameterizedCommand, List<Binding>> usual = usual();
    Stream<ParameterizedCommand> plain = Arrays.stream(commands.getDefinedCommands()).filter(CommandCatalog::isListed)
        .map(command -> new ParameterizedCommand(command, null));
    Stream<ParameterizedCommand> withValues = usual.keySet().stream().filter(c -> !c.getParameterMap().isEmpty())
        .filter(c -> c.getId().startsWith(OWN));
    Map<KeyedCommand, ParameterizedCommand> all = new LinkedHashMap<>();
    Stream.concat(plain, withValues).flatMap(command -> keyed(command, usual).stream().map(k -> Map.entry(k, command)))
        .sorted(Comparator.comparing(e -> e.getKey().name())).forEach(e -> all.put(e.getKey(), e.getValue()));
    return all;
  }

  /** The keys that commands have without users' changes. */
  Map<ParameterizedCommand, List<Binding>> usual() {
    return Arrays.stream(bindings.getBindings())
        .filter(b -> b.getParameterizedCommand() != null && b.getContextId().equals(CONTEXT)
            && b.getType() == Binding.SYSTEM && b.getTriggerSequence() instanceof KeySequence)
        .filter(b -> Optional.ofNullable(b.getPlatform()).filter(p -> !p.equals(bindings.getPlatform())).isEmpty())
        .collect(Collectors.groupingBy(Binding::getParameterizedCommand));
  }

  private static boolean isListed(Command command) {
    try {
      boolean other = !command.getCategory().getId().startsWith(PLATFORM) && !command.getId().startsWith(PLATFORM);
      return (other || OF_PLATFORM.contains(command.getId())) && !needsValues(command);
    } catch (NotDefinedException e) {
      return false; // its plug-in has just gone
    }
  }

  private static boolean needsValues(Command command) throws NotDefinedException {
    IParameter[] parameters = command.getParameters();
    return parameters != null && Arrays.stream(parameters).anyMatch(parameter -> !parameter.isOptional());
  }

  private static Optional<KeyedCommand> keyed(ParameterizedCommand command,
      Map<ParameterizedCommand, List<Binding>> usual) {
    try {
      boolean stop = command.getId().equals(STOP);
      List<KeySequence> keys = stop ? List.of(KeyRules.STOP)
          : usual.getOrDefault(command, List.of()).stream()
              .map(b -> (KeySequence) b.getTriggerSequence()).sorted(Comparator.comparing(KeySequence::toString))
              .toList();
      return Optional.of(new KeyedCommand(id(command), name(command), command.getCommand().getCategory().getName(),
          Optional.ofNullable(command.getCommand().getDescription()).orElse(""), keys, stop));
    } catch (NotDefinedException e) {
      return Optional.empty();
    }
  }

  /** Ours have short ones, so that a file of keys can be written by hand. */
  private static String id(ParameterizedCommand command) {
    String values = command.getParameterMap().isEmpty() ? "" : "(" + values(command) + ")";
    return command.getId().replaceFirst("^org\\.robotui\\.workbench\\.command\\.", "") + values;
  }

  private static String name(ParameterizedCommand command) throws NotDefinedException {
    String name = command.getCommand().getName();
    return command.getParameterMap().isEmpty() ? name : name + " " + values(command);
  }

  private static String values(ParameterizedCommand command) {
    return String.join(",", ((Map<?, ?>) command.getParameterMap()).values().stream().map(String::valueOf).toList());
  }
}
