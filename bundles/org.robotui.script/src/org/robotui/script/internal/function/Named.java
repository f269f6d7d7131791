package org.robotui.script.internal.function;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.api.command.Authority;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.api.script.ScriptCall;
import org.robotui.api.script.ScriptFailure;

/** What arguments of functions name. */
final class Named {
  private Named() {}

  /** The RUIC that an argument names, else the used one. */
  static Ruic ruic(ScriptCall call, int index) throws ScriptFailure {
    return call.ruic(call.textIf(index));
  }

  /** The port that an argument names, as {@code component.port}; a port's own name may contain dots. */
  static SourceId port(ScriptCall call, int index) throws ScriptFailure {
    String text = call.text(index);
    int dot = text.indexOf('.');
    if (dot < 1 || dot == text.length() - 1) {
      throw new ScriptFailure(
          "'" + text + "' is no port; a port is named by its robot interface and its name, as base.odom; see ports()");
    }
    return new SourceId(text.substring(0, dot), text.substring(dot + 1));
  }

  /** The robot that an argument names, of whatever RUIC; else the only one of the used RUIC. */
  static Authority robot(ScriptCall call, int index) throws ScriptFailure {
    Optional<String> name = call.textIf(index);
    List<Authority> all = name.isEmpty() ? call.ruic(Optional.empty()).authorities()
        : call.host().ruics().stream().flatMap(r -> r.authorities().stream())
            .filter(a -> a.robot().equals(name.get())).limit(1).toList();
    if (all.size() == 1) {
      return all.getFirst();
    }
    String there = call.host().ruics().stream().flatMap(r -> r.authorities().stream()).map(Authority::robot).distinct()
        .collect(Collectors.joining(", "));
    throw new ScriptFailure(name.map(n -> "there is no robot '" + n + "'; there are: " + there)
        .orElse("there are several robots; name one of: " + there));
  }

  /** The only port of a kind and a type that a RUIC offers. */
  static SourceId only(Ruic ruic, PortKind kind, String type) throws ScriptFailure {
    List<SourceId> all = ruic.snapshot().ports().stream()
        .filter(p -> p.kind() == kind && p.typeName().equals(type)).map(PortStatus::port).toList();
    if (all.size() == 1) {
      return all.getFirst();
    }
    throw new ScriptFailure(all.isEmpty() ? ruic.name() + " offers no " + word(kind) + " for " + type + " now"
        : ruic.name() + " offers several ports for " + type + "; name one of: "
            + all.stream().map(SourceId::toString).collect(Collectors.joining(", ")));
  }

  static String word(Enum<?> constant) {
    return constant.name().toLowerCase(Locale.ROOT);
  }
}
