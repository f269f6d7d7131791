package org.robotui.workbench.internal.pane;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.ScrolledComposite;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.Subject;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.show.DraggedPorts;
import org.robotui.ui.show.PortDrag;
import org.robotui.workbench.internal.model.PortRow;
import org.robotui.workbench.internal.model.RobotRow;

/** All robots, and the ports of the selected one. Display thread only. */
public final class Navigator extends Composite {
  /** What the navigator does; robots are named. */
  public interface Actions {
    /** Lets the user choose a configuration and loads it. */
    void open();

    /** Puts together a UI for a robot that has none. */
    void create();

    /** Shows a robot in this window. */
    void select(String ruic);

    /** Shows it no more. */
    void unselect(String ruic);

    /** Starts it anew. */
    void restart(String ruic);

    /** Takes it away. */
    void remove(String ruic);

    /** How it is called to take it away, where it is a file that was opened. */
    default Optional<String> closing(String ruic) {
      return Optional.empty();
    }

    /** Shows what is connected, and why. */
    void connections(String ruic);

    /** Opens the menu of a port at the pointer. */
    void portMenu(Control over, String ruic, SourceId port);

    /** Asks for another framework in place of the one that it has. */
    void exchange(String ruic);

    /** Shows what its configuration says, to be changed. */
    void settings(String ruic);
  }

  private static final int HEADING = 36;
  private static final int LOWEST_SCROLLER = 60;

  private final Theme theme;
  private final Actions actions;
  private final RobotList robots;
  private final ShortenedLabel portsHeading;
  private final PortList ports;
  private final ScrolledComposite scroller;
  private String selected = "";
  private int shownHeight;

  /** Makes an empty navigator. */
  public Navigator(Composite parent, Theme theme, Actions actions) {
    super(parent, SWT.NONE);
    this.theme = theme;
    this.actions = actions;
    setBackground(theme.color(Role.PANEL));
    GridLayout layout = new GridLayout(1, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.verticalSpacing = 0;
    setLayout(layout);
    heading("ROBOTS");
    robots = new RobotList(this, theme, actions::select);
    robots.setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    robots.addListener(SWT.MenuDetect, e -> contextMenu());
    addButtons();
    portsHeading = heading("");
    scroller = new ScrolledComposite(this, SWT.V_SCROLL);
    ports = new PortList(scroller, theme);
    ports.addListener(SWT.MenuDetect,
        e -> ports.meant(e).flatMap(PortRow::port).ifPresent(port -> actions.portMenu(ports, selected, port)));
    PortDrag.from(ports, at -> ports.at(at.y).flatMap(PortRow::port)
        .map(port -> new DraggedPorts(selected, List.of(Subject.Stream.of(port)))));
    scroll();
  }

  /** Shows robots and the ports of the selected one. */
  public void show(List<RobotRow> rows, Optional<String> shown, List<PortRow> portsOfShown) {
    selected = shown.orElse("");
    robots.show(rows, selected);
    portsHeading.show(Role.DIM, shown.map(name -> name.toUpperCase(Locale.ROOT) + " \u00b7 PORTS").orElse(""));
    ports.show(portsOfShown);
    if (portsHeight() != shownHeight) {
      shownHeight = portsHeight();
      layout(true);
      fitScroller();
    }
  }

  /** The list of ports. */
  public PortList ports() {
    return ports;
  }

  /** The list of robots. */
  public RobotList robots() {
    return robots;
  }

  @Override
  public boolean setFocus() {
    return robots.setFocus();
  }

  private ShortenedLabel heading(String text) {
    ShortenedLabel words = new ShortenedLabel(this, theme, Face.SMALL_STRONG, Role.DIM, text);
    GridData data = new GridData(SWT.FILL, SWT.TOP, true, false);
    data.heightHint = HEADING;
    data.horizontalIndent = Theme.EDGE + 2;
    words.setLayoutData(data);
    return words;
  }

  private void addButtons() {
    place(new QuietButton(this, theme, actions::create).icon(Icon.PLUS).text("New robot UI\u2026")
        .hint("Ask a robot what it offers, and write a configuration for it (Ctrl+Shift+N)"), 2 * Theme.STEP);
    place(new QuietButton(this, theme, actions::open).icon(Icon.TEXT).text("Open configuration\u2026")
        .hint("Open a configuration file and add its robots (Ctrl+O)"), 0);
    ShortenedLabel gap = new ShortenedLabel(this, theme, Face.SMALL, Role.DIM, "");
    gap.setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
  }

  private static void place(QuietButton button, int indent) {
    GridData data = new GridData(SWT.BEGINNING, SWT.TOP, true, false);
    data.verticalIndent = indent;
    button.setLayoutData(data);
  }

  private void scroll() {
    GridData data = new GridData(SWT.FILL, SWT.END, true, false);
    scroller.setLayoutData(data);
    scroller.setBackground(theme.color(Role.PANEL));
    scroller.setExpandHorizontal(true);
    scroller.setExpandVertical(true);
    scroller.setContent(ports);
    scroller.addListener(SWT.Resize, e -> fitScroller());
    addListener(SWT.Resize, e -> layout(true));
    limitPorts();
  }

  /** Without a height there is nothing to scroll, and no room for a scroll bar. */
  private void fitScroller() {
    scroller.setMinHeight(scroller.getSize().y < LOWEST_SCROLLER ? 0 : portsHeight());
  }

  private int portsHeight() {
    return ports.computeSize(SWT.DEFAULT, SWT.DEFAULT).y;
  }

  /** At most half of the navigator. */
  private void limitPorts() {
    GridData data = (GridData) scroller.getLayoutData();
    int wanted = portsHeight() + 2 * Theme.STEP;
    data.heightHint = Math.min(wanted, Math.max(0, getSize().y / 2));
  }

  @Override
  public void layout(boolean changed) {
    if (ports != null && !ports.isDisposed()) {
      limitPorts();
    }
    super.layout(changed);
  }

  private void contextMenu() {
    PopupMenu menu =
        new PopupMenu(this).push("New robot UI\u2026", actions::create).push("Open configuration\u2026", actions::open);
    robots.pointed().map(RobotRow::name).ifPresent(name -> robotItems(menu, name));
    menu.open();
  }

  private void robotItems(PopupMenu menu, String name) {
    menu.line();
    if (name.equals(selected)) {
      menu.push("Unselect", () -> actions.unselect(name));
    } else {
      menu.push("Select", () -> actions.select(name));
    }
    menu.push("Show connections", () -> actions.connections(name));
    menu.push("Change framework\u2026", () -> actions.exchange(name));
    menu.push("Settings\u2026", () -> actions.settings(name));
    menu.push("Restart", () -> actions.restart(name));
    menu.line();
    menu.push(actions.closing(name).orElse("Remove"), () -> actions.remove(name));
  }
}
