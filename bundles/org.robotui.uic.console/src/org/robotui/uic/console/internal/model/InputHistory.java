package org.robotui.uic.console.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What was typed before, and where the user is in it. Display thread. */
public final class InputHistory {
  /** As many are kept. */
  public static final int MOST = 100;
  private static final int LONGEST = 4000;

  private final List<String> typed = new ArrayList<>();
  private int at;
  private String draft = "";

  /** With what was kept. */
  public InputHistory(List<String> before) {
    before.forEach(this::keep);
    at = typed.size();
  }

  /** Takes note of what was run. */
  public void add(String text) {
    keep(text);
    at = typed.size();
    draft = "";
  }

  private void keep(String text) {
    if (text.isBlank() || text.length() > LONGEST) {
      return;
    }
    typed.remove(text);
    typed.add(text);
    if (typed.size() > MOST) {
      typed.removeFirst();
    }
  }

  /** The one before, where there is one. */
  public Optional<String> older(String shown) {
    if (at == 0) {
      return Optional.empty();
    }
    if (at == typed.size()) {
      draft = shown;
    }
    at--;
    return Optional.of(typed.get(at));
  }

  /** The one after, and what the user had begun to type after the newest. */
  public Optional<String> newer() {
    if (at == typed.size()) {
      return Optional.empty();
    }
    at++;
    return Optional.of(at == typed.size() ? draft : typed.get(at));
  }

  /** All, the oldest first. */
  public List<String> all() {
    return List.copyOf(typed);
  }
}
