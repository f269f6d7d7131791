package org.robotui.workbench.internal.pane;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.QuietButton;
import org.robotui.workbench.internal.model.Lease;
import org.robotui.workbench.internal.model.RecordWords;
import org.robotui.workbench.internal.model.Stops;

/**
 * The bar at the top of a window: product, menu, search, who drives, and the stop at its one place. What it shows keeps
 * its place when the stop is latched. Display thread only.
 */
public final class TopBar extends Composite {
  /** What the bar does. */
  public interface Actions {
    /** Pops up a menu below a control. */
    void menu(String id, Control below);

    /** Opens the search for commands and views. */
    void search();

    /** Pops up what can be recorded, below a control. */
    void record(Control below);

    /** Takes or gives back the lease. */
    void lease();

    /** Stops all robots. */
    void stop();

    /** Releases all stops. */
    void release();
  }

  /**
   * A menu of the bar.
   *
   * @param id as {@link Actions#menu} gets it
   * @param label what users read
   */
  public record MenuTitle(String id, String label) {}

  private static final int HEIGHT = 44;
  private static final int BUTTON_HEIGHT = 30;
  private static final int SEARCH_WIDTH = 300;
  /** With less there is no search field: its keys would be cut off. */
  private static final int LEAST_SEARCH_WIDTH = 80;
  private static final int RECORD_WIDTH = 138;
  private static final int LEAST_RECORD_WIDTH = 28;
  private static final int RECORD_GAP = 2;
  private static final int LEASE_WIDTH = 190;
  private static final int LEAST_LEASE_WIDTH = 60;
  private static final int STOP_WIDTH = 136;

  private final Theme theme;
  private final RecordLamp record;
  private final LeaseLamp lease;
  private final ShortenedLabel stopped;
  private final QuietButton release;
  private final QuietButton stop;
  private final SearchField search;
  private final List<Control> menuButtons = new ArrayList<>();
  private Stops stops = new Stops(List.of(), List.of());
  private boolean operated;
  private boolean recordable = true;

  /** Makes the bar. */
  public TopBar(Composite parent, Theme theme, List<MenuTitle> menus, Actions actions) {
    super(parent, SWT.NONE);
    this.theme = theme;
    setBackground(theme.color(Role.GROUND));
    GridLayout layout = new GridLayout(menus.size() + 9, false);
    layout.marginHeight = 0;
    layout.marginWidth = Theme.EDGE;
    layout.horizontalSpacing = 2;
    setLayout(layout);
    product();
    menus.forEach(m -> menu(m, actions));
    spring();
    search = search(actions);
    spring();
    stopped = place(new ShortenedLabel(this, theme, Face.BODY_STRONG, Role.BAD, ""), 0);
    of(stopped).heightHint = SWT.DEFAULT;
    of(stopped).horizontalIndent = 2 * Theme.STEP;
    release = place(new QuietButton(this, theme, actions::release), SWT.DEFAULT).text(stops.release());
    release.setVisible(false);
    record = place(new RecordLamp(this, theme, actions::record), RECORD_WIDTH);
    lease = place(new LeaseLamp(this, theme, actions::lease), LEASE_WIDTH);
    stop = place(new QuietButton(this, theme, actions::stop), STOP_WIDTH).text("STOP  (F12)").fill(Role.BAD)
        .hint("Stop all robots and keep them stopped until released (F12, or space in a view)");
    of(lease).horizontalIndent = Theme.STEP;
    of(stop).horizontalIndent = 2 * Theme.STEP;
    addListener(SWT.Resize, e -> fit());
    // Line at the lower edge.
    addPaintListener(e -> {
      e.gc.setForeground(theme.color(Role.LINE));
      e.gc.drawLine(0, getSize().y - 1, getSize().x, getSize().y - 1);
    });
  }

  /** Which keys open the search, empty for none. */
  public void searchKeys(String keys) {
    search.keys(keys);
  }

  /** For an operator there are no menus and no search. */
  public void operated(boolean now) {
    if (operated != now) {
      operated = now;
      menuButtons.forEach(button -> {
        button.setVisible(!now);
        of(button).exclude = now;
      });
      fit();
    }
  }

  /** Shows who drives, and which robots are stopped. */
  public void show(Lease shown, Stops now) {
    lease.show(shown);
    if (!stops.equals(now)) {
      stops = now;
      release.text(now.release()).hint(now.releaseHint());
      release.setVisible(now.any());
      stopped.show(Role.BAD, now.words(), "Stopped: " + String.join(", ", now.stopped()));
      stop.text(now.button());
      fit();
    }
  }

  /** Shows what is recorded; nothing where nothing can be. */
  public void recording(Optional<RecordWords> words) {
    words.ifPresent(record::show);
    if (recordable != words.isPresent()) {
      recordable = words.isPresent();
      fit();
    }
  }

  @Override
  public org.eclipse.swt.graphics.Point computeSize(int widthHint, int heightHint, boolean changed) {
    org.eclipse.swt.graphics.Point size = super.computeSize(widthHint, heightHint, changed);
    return new org.eclipse.swt.graphics.Point(size.x, HEIGHT);
  }

  private void product() {
    ShortenedLabel name = new ShortenedLabel(this, theme, Face.TITLE, Role.TEXT, "RobotUI");
    GridData data = new GridData(SWT.BEGINNING, SWT.CENTER, false, true);
    data.widthHint = name.computeSize(SWT.DEFAULT, SWT.DEFAULT).x + 2 * Theme.EDGE;
    name.setLayoutData(data);
  }

  private void menu(MenuTitle title, Actions actions) {
    MenuButton button = new MenuButton(this, theme, title, actions);
    button.setLayoutData(new GridData(SWT.BEGINNING, SWT.CENTER, false, true));
    menuButtons.add(button);
  }

  /**
   * In a narrow window the search gives way, then which are stopped, then what is recorded, then who drives, then the
   * place of the button that releases: the stop is always seen.
   */
  private void fit() {
    width(search, operated ? 0 : SEARCH_WIDTH);
    width(lease, LEASE_WIDTH);
    width(record, RECORD_WIDTH);
    width(stopped, stopped.computeSize(SWT.DEFAULT, SWT.DEFAULT).x);
    of(release).exclude = false;
    recordShown(recordable);
    int missing = super.computeSize(SWT.DEFAULT, SWT.DEFAULT, true).x - getClientArea().width;
    missing = narrow(search, 0, missing);
    search.setVisible(of(search).widthHint >= LEAST_SEARCH_WIDTH);
    missing = narrow(stopped, 0, missing);
    missing = narrow(record, LEAST_RECORD_WIDTH, missing);
    missing = narrow(lease, LEAST_LEASE_WIDTH, missing);
    if (missing > 0 && recordable) {
      recordShown(false);
      missing -= LEAST_RECORD_WIDTH + RECORD_GAP;
    }
    of(release).exclude = missing > 0 && !release.getVisible();
    layout();
  }

  private void recordShown(boolean now) {
    record.setVisible(now);
    of(record).exclude = !now;
  }

  /** What is missing then. */
  private static int narrow(Control control, int least, int missing) {
    int before = of(control).widthHint;
    width(control, Math.clamp(before - (long) missing, least, before));
    return missing - (before - of(control).widthHint);
  }

  private static void width(Control control, int width) {
    of(control).widthHint = width;
  }

  private static GridData of(Control control) {
    return (GridData) control.getLayoutData();
  }

  private SearchField search(Actions actions) {
    SearchField field = new SearchField(this, theme, actions::search);
    GridData data = new GridData(SWT.CENTER, SWT.CENTER, false, true);
    data.widthHint = SEARCH_WIDTH;
    data.heightHint = BUTTON_HEIGHT;
    field.setLayoutData(data);
    return field;
  }

  private void spring() {
    ShortenedLabel gap = new ShortenedLabel(this, theme, Face.BODY, Role.TEXT, "");
    GridData data = new GridData(SWT.FILL, SWT.CENTER, true, false);
    data.heightHint = 1;
    gap.setLayoutData(data);
  }

  private <C extends Control> C place(C control, int width) {
    GridData data = new GridData(SWT.END, SWT.CENTER, false, true);
    data.heightHint = BUTTON_HEIGHT;
    data.widthHint = width;
    control.setLayoutData(data);
    return control;
  }
}
