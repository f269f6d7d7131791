package org.robotui.workbench.internal.keys;

import java.util.Arrays;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.jface.bindings.keys.IKeyLookup;
import org.eclipse.jface.bindings.keys.KeyLookupFactory;
import org.eclipse.jface.bindings.keys.KeySequence;
import org.eclipse.jface.bindings.keys.KeyStroke;
import org.eclipse.swt.SWT;

/** Which keys a command may not have, whatever the user wants. */
public final class KeyRules {
  /** The key that stops all robots. */
  public static final KeySequence STOP = KeyWords.read("F12").orElseThrow();

  private static final int MODIFIERS = SWT.CTRL | SWT.ALT | SWT.COMMAND;
  private static final Set<KeyStroke> OF_TEXTS = Stream.of("Ctrl+C", "Ctrl+X", "Ctrl+V", "Ctrl+A")
      .map(text -> stroke(text)).collect(Collectors.toUnmodifiableSet());
  private static final Set<Integer> FUNCTION_KEYS = functionKeys();

  private KeyRules() {}

  /**
   * Why a command cannot have its keys changed.
   *
   * @return a sentence for users, or none where it can
   */
  public static Optional<String> fixed(KeyedCommand command) {
    return command.fixed() ? Optional.of("'" + command.name() + "' keeps " + KeyWords.text(command.usual())
        + ": the key that stops robots cannot be changed or taken away.") : Optional.empty();
  }

  /**
   * Why a key cannot be given to any command.
   *
   * @return a sentence for users, or none where it can
   */
  public static Optional<String> refusal(KeySequence keys) {
    return Arrays.stream(keys.getKeyStrokes()).flatMap(stroke -> refusal(stroke).stream()).findFirst();
  }

  private static Optional<String> refusal(KeyStroke stroke) {
    String text = KeyWords.text(KeySequence.getInstance(stroke));
    if (stroke.equals(STOP.getKeyStrokes()[0])) {
      return Optional.of(text + " stops all robots, in every window, and is kept for that.");
    }
    if (OF_TEXTS.contains(stroke)) {
      return Optional.of(text + " is kept for texts: copy, cut, paste, select all.");
    }
    boolean alone = (stroke.getModifierKeys() & MODIFIERS) == 0;
    return alone && !FUNCTION_KEYS.contains(stroke.getNaturalKey())
        ? Optional.of(text + " alone is for texts and for the view that has the focus. Take Ctrl or Alt with it, or a"
            + " function key.")
        : Optional.empty();
  }

  private static KeyStroke stroke(String text) {
    return KeyWords.read(text).orElseThrow().getKeyStrokes()[0];
  }

  private static Set<Integer> functionKeys() {
    IKeyLookup lookup = KeyLookupFactory.getDefault();
    Function<String, Integer> code = lookup::formalKeyLookup;
    return Stream.iterate(1, number -> number + 1).limit(20).map(number -> code.apply("F" + number))
        .collect(Collectors.toUnmodifiableSet());
  }
}
