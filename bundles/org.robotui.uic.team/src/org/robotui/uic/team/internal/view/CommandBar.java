package org.robotui.uic.team.internal.view;

import java.util.Collection;
import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.uic.team.internal.model.TeamCommands;

/**
 * What can be done with the selected robots, or with all where none is selected: the buttons, a question before what
 * concerns all, and what became of it. A stop asks nothing. Display thread.
 */
final class CommandBar {
  private static final int SHOWN_MILLIS = 6000;

  /** A command, and to whom. */
  private record Wish(String question, Runnable command) {}

  private final TeamCommands commands;
  private final Composite root;
  private final QuietButton stop;
  private final QuietButton release;
  private final QuietButton zero;
  private final QuietButton open;
  private final Composite ask;
  private final NoticeLine question;
  private final QuietButton yes;
  private final NoticeLine answer;
  private Wish wish = new Wish("", () -> {});
  private List<String> all = List.of();
  private List<String> selected = List.of();
  private int shown;

  CommandBar(Composite parent, Theme theme, TeamCommands commands, Composite buttons) {
    this.commands = commands;
    this.root = parent;
    stop = button(buttons, theme, Icon.STOP, "Stop at once, until released (no question is asked)", this::stop);
    release = button(buttons, theme, Icon.PLAY, "Release the stop; nothing moves by that", this::release);
    zero = button(buttons, theme, Icon.PAUSE, "Send a velocity of zero, which also ends a goal", this::zero);
    open = button(buttons, theme, Icon.OPEN, "Open the robot's own UI (Enter)", this::open);
    ask = Boxes.bar(parent, theme, 3);
    question = new NoticeLine(ask, theme, Face.BODY);
    yes = new QuietButton(ask, theme, this::yes).icon(Icon.CHECK).text("Yes").hint("Do it");
    new QuietButton(ask, theme, this::no).icon(Icon.CLOSE).text("No").hint("Do nothing (Esc)");
    Boxes.seen(ask, false);
    answer = new NoticeLine(parent, theme, Face.BODY);
    Boxes.seen(answer.control(), false);
    show(List.of(), List.of());
  }

  private static QuietButton button(Composite parent, Theme theme, Icon icon, String hint, Runnable run) {
    QuietButton button = new QuietButton(parent, theme, run).icon(icon).hint(hint);
    button.setLayoutData(new GridData(SWT.BEGINNING, SWT.CENTER, false, false));
    return button;
  }

  /** Has questions and answers stand below a control, where they move nothing that one is about to click. */
  void below(Control table) {
    answer.control().moveBelow(table);
    ask.moveBelow(table);
  }

  /** Who there is, and who is meant. */
  void show(List<String> robots, List<String> meant) {
    all = robots;
    selected = meant;
    String whom = meant.isEmpty() ? "all" : meant.size() == 1 ? meant.getFirst() : Integer.toString(meant.size());
    stop.text("Stop " + whom);
    release.text("Release " + whom);
    zero.text("Halt");
    open.text("Open");
    boolean any = !robots.isEmpty();
    List.of(stop, release, zero).forEach(b -> b.setEnabled(any));
    open.setEnabled(meant.size() == 1);
    stop.getParent().layout();
  }

  void stop() {
    tell(commands.stop(whom()));
  }

  void release() {
    confirmed("Release the stop of all " + all.size() + " robots?", () -> tell(commands.release(whom())));
  }

  void zero() {
    confirmed("Send a velocity of zero to all " + all.size() + " robots?", () -> tell(commands.zero(whom())));
  }

  void open() {
    if (selected.size() == 1) {
      tell(commands.open(selected.getFirst()));
    }
  }

  private Collection<String> whom() {
    return selected.isEmpty() ? all : selected;
  }

  /** What concerns all is asked before; two robots that were selected are meant. */
  private void confirmed(String words, Runnable command) {
    boolean everybody = selected.isEmpty() || selected.size() == all.size();
    if (everybody && all.size() > 1) {
      wish = new Wish(words, command);
      question.show(Health.WARNING, words);
      seen(ask, true);
      yes.setFocus();
    } else {
      command.run();
    }
  }

  /** The question that is asked now, empty for none. */
  String question() {
    return wish.question();
  }

  void yes() {
    Wish now = wish;
    no();
    now.command().run();
  }

  void no() {
    wish = new Wish("", () -> {});
    seen(ask, false);
  }

  /** Says for a while what became of a command. */
  void tell(CommandNotice told) {
    int mine = ++shown;
    answer.show(told.health(), told.text());
    seen(answer.control(), !told.text().isEmpty());
    root.getDisplay().timerExec(SHOWN_MILLIS, () -> {
      if (mine == shown && !root.isDisposed()) {
        seen(answer.control(), false);
      }
    });
  }

  /** What was said last. */
  String answer() {
    return answer.words();
  }

  private void seen(Control control, boolean wanted) {
    if (Boxes.seen(control, wanted)) {
      root.layout(true, true);
    }
  }
}
