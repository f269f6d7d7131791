package org.robotui.workbench.internal.keys;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.robotui.api.config.SetAside;
import org.robotui.api.config.WriteFailure;

/** The keys of this user: what holds now, kept in a file from run to run. Display thread only. */
public final class KeyStore {
  private final KeysFile file;
  private final Consumer<String> teller;
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private Keymap now;

  /**
   * Reads what was kept. Where that cannot be understood, the file is set aside, and it starts with the rest.
   *
   * @param file where
   * @param teller is given a sentence for the user where the file is damaged or cannot be written
   */
  public KeyStore(KeysFile file, Consumer<String> teller) {
    this.file = file;
    this.teller = teller;
    List<String> damage = new ArrayList<>();
    now = new Keymap(List.of(), file.read(damage::add));
    if (!damage.isEmpty()) {
      teller.accept("Of the keys that you had changed something is lost: "
          + String.join("; ", damage).replaceFirst("\\.$", "") + ". "
          + SetAside.copy(file.path()));
    }
  }

  /** What holds now. */
  public Keymap now() {
    return now;
  }

  /** All commands that there are now. */
  public void commands(List<KeyedCommand> commands) {
    if (!commands.equals(now.commands())) {
      now = now.of(commands);
      listeners.forEach(Runnable::run);
    }
  }

  /** Other keys hold from now on, and are kept. */
  public void change(Keymap next) {
    if (!next.equals(now)) {
      now = next;
      listeners.forEach(Runnable::run);
      try {
        file.write(next.changes());
      } catch (IOException e) {
        teller.accept("The keys hold for this run only: " + file.path() + " cannot be written: "
            + WriteFailure.reason(e));
      }
    }
  }

  /** Has something run after each change. Running the result ends that. */
  public Runnable onChange(Runnable listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }

  /** The first key of a command as users read it, empty where it has none. */
  public String text(String id) {
    return now.command(id).map(now::keys).filter(keys -> !keys.isEmpty()).map(keys -> KeyWords.text(keys.getFirst()))
        .orElse("");
  }
}
