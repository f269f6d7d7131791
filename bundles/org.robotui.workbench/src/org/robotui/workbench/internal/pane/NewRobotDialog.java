package org.robotui.workbench.internal.pane;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StackLayout;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.host.Composition;
import org.robotui.api.host.CompositionState;
import org.robotui.api.host.CompositionText;
import org.robotui.api.host.Host;
import org.robotui.api.host.RuicDraft;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.QuietButton;
import org.robotui.workbench.internal.model.NewRobotModel;

/**
 * A UI for a robot that has none yet, in three steps: the robot is asked what it offers, views that fit are chosen, and
 * the configuration is written. Nothing is written before the last button is pressed. Display thread only.
 */
public final class NewRobotDialog {
  private static final int REFRESH_MILLIS = 250;
  private static final int WIDTH = 1080;
  private static final int HEIGHT = 680;
  private static final List<String> STEPS = List.of("Robot", "Views", "Name");

  private final Theme theme;
  private final NewRobotModel model;
  private final Executor background;
  private final BiConsumer<Path, String> done;
  private final Shell shell;
  private final StepLine steps;
  private final Composite pages;
  private final StackLayout stack = new StackLayout();
  private final NewRobotPage robot;
  private final NewViewsPage views;
  private final NewNamePage name;
  private final NoticeLine notice;
  private final QuietButton back;
  private final QuietButton next;
  private int page;
  private int asked;
  private Optional<RuicDraft> drafted = Optional.empty();
  private Optional<CompositionText> text = Optional.empty();
  private boolean writing;

  /**
   * Makes the window.
   *
   * @param parent over which it opens
   * @param theme colours and fonts
   * @param host knows the frameworks
   * @param model what is wanted
   * @param open the configurations that are open, to which the robot can be added
   * @param background runs what reads and writes files
   * @param done is given the file and the name, after it was written
   */
  public NewRobotDialog(Shell parent, Theme theme, Host host, NewRobotModel model, List<Path> open, Executor background,
      BiConsumer<Path, String> done) {
    this.theme = theme;
    this.model = model;
    this.background = background;
    this.done = done;
    shell = DialogShell.over(parent, theme, "New robot UI");
    shell.setLayout(DialogShell.layout(1, 0, 0));
    steps = new StepLine(shell, theme, STEPS);
    pages = new Composite(shell, SWT.NONE);
    pages.setBackground(theme.color(Role.PANEL));
    pages.setLayout(stack);
    pages.setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    robot = new NewRobotPage(pages, theme, host, model, this::show);
    views = new NewViewsPage(pages, theme, model, this::show);
    name = new NewNamePage(pages, theme, model, open, this::show);
    notice = new NoticeLine(shell, theme, Face.BODY);
    Composite buttons = buttons();
    DialogShell.button(buttons, theme, shell::close).text("Cancel").hint("Write nothing (Esc)");
    back = DialogShell.button(buttons, theme, () -> turn(page - 1)).text("Back");
    next = DialogShell.button(buttons, theme, this::next).icon(Icon.CHECK).text("Next");
    shell.addListener(SWT.Dispose, e -> model.close());
    DialogShell.place(shell, WIDTH, HEIGHT);
    turn(0);
  }

  /** Shows it until it is closed. */
  public void open() {
    shell.open();
    robot.setFocus();
    refresh();
  }

  /** The window, for tests. */
  public Shell shell() {
    return shell;
  }

  /** Whether it was closed. */
  public boolean isClosed() {
    return shell.isDisposed();
  }

  private void refresh() {
    if (!shell.isDisposed()) {
      show();
      shell.getDisplay().timerExec(REFRESH_MILLIS, this::refresh);
    }
  }

  private void turn(int to) {
    page = Math.clamp(to, 0, STEPS.size() - 1);
    Control shown = List.<Control>of(robot, views, name).get(page);
    stack.topControl = shown;
    pages.layout();
    steps.show(page);
    show();
    shown.setFocus();
  }

  private void next() {
    if (page < STEPS.size() - 1) {
      turn(page + 1);
    } else {
      write();
    }
  }

  private void show() {
    Optional<CompositionState> state = model.state();
    switch (page) {
      case 0 -> robot.show(state);
      case 1 -> state.ifPresent(views::show);
      default -> draft();
    }
    boolean usable = state.filter(CompositionState::usable).isPresent();
    boolean chosen = state.filter(s -> !model.views(s).isEmpty()).isPresent();
    boolean ready = text.filter(CompositionText.Text.class::isInstance).isPresent();
    back.setEnabled(page > 0 && !writing);
    next.setEnabled(!writing && usable && (page == 0 || chosen && (page == 1 || ready)));
    next.text(page < STEPS.size() - 1 ? "Next" : "Create").checked(next.isEnabled()).requestLayout();
    say(state);
  }

  private void say(Optional<CompositionState> state) {
    switch (page) {
      case 0 -> state.ifPresentOrElse(s -> notice.show(health(s), robot.sentence(s)), this::sayWhatToType);
      case 1 -> state
          .ifPresent(s -> notice.show(model.views(s).isEmpty() ? Health.WARNING : Health.NONE, views.summary(s)));
      default -> notice.show(health(), sentence());
    }
  }

  private void sayWhatToType() {
    if (robot.isFine()) {
      notice.show(Health.NONE, "Say where the robot is, and press Connect.");
    } else {
      notice.show(Health.BAD, "Correct what is marked in the settings.");
    }
  }

  /** That nothing was typed yet is no mistake. */
  private Health health() {
    boolean refused = text.filter(CompositionText.Refused.class::isInstance).isPresent();
    return !refused ? Health.OK : model.name().isBlank() ? Health.NONE : Health.BAD;
  }

  private String sentence() {
    return text.map(t -> switch (t) {
      case CompositionText.Refused r -> r.reason();
      case CompositionText.Text x -> x.isNew() ? "A new file: " + x.file()
          : "Added to " + x.file() + ", line " + x.line() + "; all that stands in it stays";
    }).orElse("");
  }

  private static Health health(CompositionState state) {
    return switch (state.stage()) {
      case CONNECTING, LOOKING -> Health.WAITING;
      case FOUND -> state.ports().isEmpty() ? Health.WARNING : Health.OK;
      case KNOWN -> Health.WARNING;
      case UNREACHED, FAILED -> Health.BAD;
    };
  }

  /** Has the text made in the background, once for each draft. */
  private void draft() {
    Optional<RuicDraft> wanted = model.draft();
    if (wanted.isEmpty() || model.composition().isEmpty() || wanted.equals(drafted) || writing) {
      return;
    }
    drafted = wanted;
    int mine = ++asked;
    Composition composition = model.composition().get();
    later(() -> composition.text(wanted.get()), found -> {
      if (mine == asked) {
        text = Optional.of(found);
        name.show(found);
        show();
      }
    });
  }

  private void write() {
    if (text.isEmpty() || !(text.get() instanceof CompositionText.Text shown) || drafted.isEmpty()
        || model.composition().isEmpty()) {
      return;
    }
    writing = true;
    RuicDraft draft = drafted.get();
    Composition composition = model.composition().get();
    later(() -> composition.write(draft, shown), written -> {
      writing = false;
      text = Optional.of(written);
      if (written instanceof CompositionText.Text) {
        shell.close();
        done.accept(draft.file(), draft.name());
      } else {
        name.show(written);
        show();
      }
    });
  }

  private void later(java.util.function.Supplier<CompositionText> task,
      java.util.function.Consumer<CompositionText> taker) {
    background.execute(() -> {
      CompositionText result = task.get();
      if (!shell.isDisposed()) {
        shell.getDisplay().asyncExec(() -> {
          if (!shell.isDisposed()) {
            taker.accept(result);
          }
        });
      }
    });
  }

  private Composite buttons() {
    Composite buttons = new Composite(shell, SWT.NONE);
    buttons.setBackground(theme.color(Role.TITLE));
    buttons.setLayout(DialogShell.layout(4, Theme.EDGE, 0));
    buttons.setLayoutData(new GridData(SWT.FILL, SWT.BOTTOM, true, false));
    new Gap(buttons).setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    return buttons;
  }
}
