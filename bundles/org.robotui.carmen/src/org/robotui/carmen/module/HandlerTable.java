package org.robotui.carmen.module;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.carmen.format.IpcFormatException;
import org.robotui.carmen.message.IpcForm;
import org.robotui.carmen.wire.IpcFrame;

/**
 * What a module handles. A module chooses the numbers, from 199 down; a message keeps its own. Safe for all threads.
 */
final class HandlerTable {

  private static final int HIGHEST = 199;

  private final Map<String, Integer> numbers = new HashMap<>();
  private final Map<Integer, Entry> entries = new HashMap<>();

  /** A message that is handled; direct where modules send it to each other. */
  record Entry(IpcForm form, boolean direct, Handling handling) {
    Optional<IpcAnswer> take(IpcFrame frame) {
      try {
        return handling.handle(form.read(frame.body()), frame.body());
      } catch (IpcFormatException | IllegalArgumentException | ArithmeticException e) {
        handling.unreadable(String.valueOf(e.getMessage()));
        return Optional.empty();
      }
    }
  }

  synchronized int add(Entry entry) throws IOException {
    Integer number = numbers.get(entry.form().name());
    if (number == null) {
      number = HIGHEST - numbers.size();
      if (number <= 0) {
        throw new IOException("a module of IPC handles no more than " + HIGHEST + " messages");
      }
      numbers.put(entry.form().name(), number);
    }
    entries.put(number, entry);
    return number;
  }

  /** False where another has taken the message over. */
  synchronized boolean remove(String message, Handling handling) {
    Integer number = numbers.get(message);
    boolean ours = number != null && entries.containsKey(number) && entries.get(number).handling().equals(handling);
    if (ours) {
      entries.remove(number);
    }
    return ours;
  }

  synchronized Optional<Entry> handler(int number) {
    return Optional.ofNullable(entries.get(number));
  }
}
