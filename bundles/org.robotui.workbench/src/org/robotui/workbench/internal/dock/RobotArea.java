package org.robotui.workbench.internal.dock;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.host.Problem;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.pane.MessagePane;
import org.robotui.workbench.internal.pane.ProblemsPane;

/**
 * Most of a window: the views of the selected robot, or why there are none and what would help; above them what is
 * wrong with a configuration. Display thread only.
 */
public final class RobotArea extends Composite {
  /** What can be done here. */
  public interface Actions {
    /** Lets the user choose a configuration and loads it. */
    void open();

    /** Puts together a UI for a robot that has none. */
    void create();

    /** Starts the selected robot's interface anew. */
    void restart(Ruic ruic);

    /** Reads the configuration with the problems again. */
    void reload();

    /** The user has seen the problems. */
    void closeProblems();

    /** Has the user choose a view to add. */
    void addView();

    /** What one can begin with, in place of words, where there is no robot and the user wants it. */
    Optional<Control> welcome(Composite parent, Theme theme);
  }

  private static final String WELCOME = "welcome";

  private final Theme theme;
  private final Actions actions;
  private final Function<Ruic, ArrangeHistory> histories;
  private Optional<ProblemsPane> problems = Optional.empty();
  private Optional<RuicSurface> surface = Optional.empty();
  private Optional<Control> message = Optional.empty();
  private String said = "";
  private boolean locked;

  /**
   * Makes an area that shows nothing yet.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param histories how the views of RUICs were arranged before; outlives the area
   * @param actions what can be done
   */
  public RobotArea(Composite parent, Theme theme, Function<Ruic, ArrangeHistory> histories, Actions actions) {
    super(parent, SWT.NONE);
    this.theme = theme;
    this.histories = histories;
    this.actions = actions;
    setBackground(theme.color(Role.PANEL));
    GridLayout layout = new GridLayout(1, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.verticalSpacing = 0;
    setLayout(layout);
  }

  /** Shows problems above the views; none takes the panel away. */
  public void problems(List<Problem> found) {
    problems.ifPresent(Control::dispose);
    problems = found.isEmpty() ? Optional.empty()
        : Optional.of(new ProblemsPane(this, theme, found, actions::reload, actions::closeProblems));
    problems.ifPresent(p -> {
      p.setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
      p.moveAbove(null);
    });
    layout(true);
  }

  /** Shows a RUIC as it is now. */
  public void show(Optional<Ruic> ruic) {
    if (ruic.isEmpty()) {
      begin();
    } else {
      show(ruic.get(), ruic.get().snapshot());
    }
  }

  private void begin() {
    if (said.equals(WELCOME)) {
      return;
    }
    Optional<Control> welcome = actions.welcome(this, theme);
    welcome.ifPresent(page -> {
      clear();
      said = WELCOME;
      page.setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
      message = welcome;
      layout(true);
    });
    if (welcome.isEmpty()) {
      say(Health.NONE, "No robot is selected",
          "Select a robot at the left, make a UI for a new one, or open a configuration that names one.",
          List.of(new MessagePane.Choice("New robot UI\u2026", actions::create),
              new MessagePane.Choice("Open configuration\u2026", actions::open)));
    }
  }

  /** Has views stay where they lie, or lets users arrange them again. */
  public void lock(boolean now) {
    locked = now;
    surface.ifPresent(s -> s.lock(now));
  }

  /** The surface of the RUIC that is shown. */
  public Optional<RuicSurface> surface() {
    return surface;
  }

  @Override
  public boolean setFocus() {
    return surface.map(RuicSurface::setFocus).or(() -> message.map(Control::setFocus)).orElseGet(super::setFocus);
  }

  private void show(Ruic ruic, RuicSnapshot now) {
    if (now.state() == RuicState.FAILED) {
      say(Health.BAD, ruic.name() + " failed", now.reason(),
          List.of(new MessagePane.Choice("Restart", () -> actions.restart(ruic))));
    } else if (now.state() == RuicState.ADDED || now.state() == RuicState.SHUT_DOWN) {
      say(Health.WAITING, ruic.name() + (now.state() == RuicState.ADDED ? " is starting" : " has ended"), "",
          List.of());
    } else if (surface.filter(s -> s.ruic() == ruic).isPresent()) {
      surface.get().arranged();
      surface.get().showInstances(now);
    } else {
      build(ruic);
    }
  }

  private void build(Ruic ruic) {
    clear();
    RuicSurface next = new RuicSurface(this, theme, ruic, histories.apply(ruic), actions::addView);
    next.setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    next.lock(locked);
    surface = Optional.of(next);
    layout(true);
  }

  private void say(Health health, String title, String sentence, List<MessagePane.Choice> choices) {
    String words = title + "\n" + sentence;
    if (message.isEmpty() || !said.equals(words)) {
      clear();
      said = words;
      MessagePane pane = new MessagePane(this, theme, health, title, sentence, choices);
      pane.setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
      message = Optional.of(pane);
      layout(true);
    }
  }

  private void clear() {
    // Forgotten first: what is being disposed is asked for the focus.
    List<Control> former = Stream.concat(surface.stream(), message.stream()).map(Control.class::cast).toList();
    surface = Optional.empty();
    message = Optional.empty();
    former.forEach(Control::dispose);
    said = "";
  }
}
