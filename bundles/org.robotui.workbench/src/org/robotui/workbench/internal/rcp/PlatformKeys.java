package org.robotui.workbench.internal.rcp;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.core.commands.ParameterizedCommand;
import org.eclipse.e4.ui.bindings.EBindingService;
import org.eclipse.jface.bindings.Binding;
import org.eclipse.jface.bindings.keys.KeySequence;
import org.eclipse.ui.services.IServiceLocator;
import org.robotui.workbench.internal.keys.KeyStore;
import org.robotui.workbench.internal.keys.KeyedCommand;

/**
 * Has the platform run commands by the keys of the user, and tells which commands there are. Menus show these keys, as
 * the platform asks for them whenever it shows one. Display thread only.
 */
@SuppressWarnings("restriction") // what the platform has for everybody keeps keys once more, in a store of its own
final class PlatformKeys {
  private final CommandCatalog catalog;
  private final EBindingService bindings;
  private final KeyStore store;
  private Map<KeySequence, Binding> active = new HashMap<>();

  PlatformKeys(IServiceLocator locator, KeyStore store) {
    catalog = new CommandCatalog(locator);
    bindings = locator.getService(EBindingService.class);
    this.store = store;
  }

  /** Begins: keys that the user has changed before hold from now on. */
  void follow() {
    catalog.usual().values().forEach(usual -> usual.forEach(b -> active.put(keys(b), b)));
    store.onChange(this::apply);
    store.commands(catalog.all().keySet().stream().toList());
  }

  private void apply() {
    Map<KeyedCommand, ParameterizedCommand> all = catalog.all();
    Map<ParameterizedCommand, List<Binding>> usual = catalog.usual();
    Map<KeySequence, Binding> next = new HashMap<>();
    store.now().bound().forEach((keys, command) -> Optional.ofNullable(all.get(command))
        .filter(c -> !command.fixed()).ifPresent(c -> next.put(keys, binding(keys, c, usual))));
    active.values().stream().filter(b -> !next.containsValue(b) && isOurs(b, all)).forEach(bindings::deactivateBinding);
    next.values().stream().filter(b -> !active.containsValue(b)).forEach(bindings::activateBinding);
    active = next;
  }

  /** The platform's own keys for what is not listed stay. */
  private static boolean isOurs(Binding binding, Map<KeyedCommand, ParameterizedCommand> all) {
    return all.containsValue(binding.getParameterizedCommand());
  }

  /** Those of users come before those that the platform has for commands of its own. */
  private Binding binding(KeySequence keys, ParameterizedCommand command,
      Map<ParameterizedCommand, List<Binding>> usual) {
    return usual.getOrDefault(command, List.of()).stream().filter(b -> keys(b).equals(keys)).findFirst()
        .orElseGet(() -> bindings.createBinding(keys, command, CommandCatalog.CONTEXT,
            Map.of(EBindingService.TYPE_ATTR_TAG, "user")));
  }

  private static KeySequence keys(Binding binding) {
    return (KeySequence) binding.getTriggerSequence();
  }
}
