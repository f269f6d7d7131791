package org.robotui.workbench.internal.pane;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.SashForm;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Listener;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.layout.Layout;
import org.robotui.api.show.Subject;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/** The views of one RUIC, laid out as its abstract layout says. Display thread only. */
public final class RuicSurface extends Composite {
  private static final int SASH = 3;
  private static final double UNITS = 1000;

  private final Theme theme;
  private final Ruic ruic;
  private final Map<String, int[]> shares;
  private final Map<String, SashForm> sashes = new HashMap<>();
  private final List<ViewStack> stacks = new ArrayList<>();
  private Optional<ViewStack> last = Optional.empty();

  /**
   * Makes the controls of all views that are seen.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param ruic whose views
   * @param shares how the user divided the splits before, by their place in the layout; kept up to date
   */
  public RuicSurface(Composite parent, Theme theme, Ruic ruic, Map<String, int[]> shares) {
    super(parent, SWT.NONE);
    this.theme = theme;
    this.ruic = ruic;
    this.shares = shares;
    setBackground(theme.color(Role.PANEL));
    setLayout(new FillLayout());
    build(this, ruic.layout(), "0");
    addListener(SWT.Dispose, e -> keepShares());
    markFocus();
  }

  /** The RUIC that it shows. */
  public Ruic ruic() {
    return ruic;
  }

  /** Shows the instances that run now; called when the RUIC changed. */
  public void showInstances(RuicSnapshot now) {
    stacks.forEach(s -> s.showInstances(now));
  }

  /** All its views, in the order of the layout. */
  public List<ViewEntry> views() {
    List<ComponentStatus> components = ruic.snapshot().components();
    List<String> failed =
        components.stream().filter(c -> c.state() == RuicState.FAILED).map(ComponentStatus::id).toList();
    return stacks.stream().flatMap(s -> s.holders()
        .map(h -> new ViewEntry(h.id(), type(components, h.id()), ruic.title(h.id()), failed.contains(h.id()),
            s.isSeen(h), h.actions(), h.keys())))
        .toList();
  }

  private static String type(List<ComponentStatus> components, String id) {
    return components.stream().filter(c -> c.kind() == ComponentStatus.Kind.UIC && c.id().equals(id)).findFirst()
        .map(ComponentStatus::type).orElse("");
  }

  /** Brings a view to the front of its tabs and gives it the keys. */
  public void reveal(String uic) {
    stacks.forEach(s -> s.reveal(uic));
  }

  /** The view that has the keys. */
  public Optional<ViewEntry> focused() {
    return seenIn(stacks.stream().filter(ViewStack::holdsFocus).findFirst());
  }

  /** The view that had the keys last: a menu in which something is chosen for it has taken them. */
  public Optional<ViewEntry> lastFocused() {
    return seenIn(last.filter(stack -> !stack.isDisposed()));
  }

  private Optional<ViewEntry> seenIn(Optional<ViewStack> stack) {
    Optional<String> id = stack.map(ViewStack::seenId);
    return views().stream().filter(v -> id.filter(v.id()::equals).isPresent()).findFirst();
  }

  /** Has a view show what its last ticks prepared. */
  public void refresh(String uic) {
    stacks.forEach(s -> s.refresh(uic));
  }

  /** Brings a view to the front and has it show something that the user pointed at. */
  public void view(String uic, String showing, Subject subject) {
    stacks.forEach(s -> s.view(uic, showing, subject));
  }

  /** Takes the view out whose code took part in a failure on the display thread; false where no view did. */
  public boolean blame(Throwable failure) {
    // One view's control may be laid out or painted from within another's code: the nearest one failed.
    Optional<ViewHolder> guilty = stacks.stream().flatMap(ViewStack::holders).filter(h -> h.guilt(failure).isPresent())
        .min(Comparator.comparingInt(h -> h.guilt(failure).getAsInt()));
    // Later: this may be called from within the paint that failed, which goes on after it.
    guilty.ifPresent(holder -> getDisplay().asyncExec(() -> {
      if (!holder.isDisposed()) {
        holder.fail(failure);
      }
    }));
    return guilty.isPresent();
  }

  @Override
  public boolean setFocus() {
    return stacks.stream().filter(s -> !s.isDisposed()).findFirst().map(ViewStack::setFocus).orElseGet(super::setFocus);
  }

  /** The line above the view that has the keys says so. */
  private void markFocus() {
    Listener mark = e -> stacks.stream().filter(s -> !s.isDisposed()).forEach(stack -> {
      stack.markFocus();
      last = stack.holdsFocus() ? Optional.of(stack) : last;
    });
    Listener later = e -> getDisplay().asyncExec(() -> mark.handleEvent(e));
    getDisplay().addFilter(SWT.FocusIn, mark);
    getDisplay().addFilter(SWT.FocusOut, later);
    addListener(SWT.Dispose, e -> {
      getDisplay().removeFilter(SWT.FocusIn, mark);
      getDisplay().removeFilter(SWT.FocusOut, later);
    });
  }

  private void build(Composite parent, Layout layout, String place) {
    switch (layout) {
      case Layout.View view -> stacks.add(new ViewStack(parent, theme, ruic, List.of(view.uic())));
      case Layout.Tabs tabs -> stacks.add(new ViewStack(parent, theme, ruic, tabs.uics()));
      case Layout.Split split -> split(parent, split, place);
    }
  }

  private void split(Composite parent, Layout.Split split, String place) {
    SashForm form = new Splitter(parent, split.direction());
    form.setBackground(theme.mix(Role.LINE, Role.GROUND, 0.6));
    form.setSashWidth(SASH);
    for (int i = 0; i < split.parts().size(); i++) {
      build(form, split.parts().get(i), place + "." + i);
    }
    form.setWeights(weights(split, place));
    sashes.put(place, form);
  }

  /** Not a plain sash form, which style sheets would colour. */
  private static final class Splitter extends SashForm {
    Splitter(Composite parent, Layout.Direction direction) {
      super(parent, (direction == Layout.Direction.ROW ? SWT.HORIZONTAL : SWT.VERTICAL) | SWT.SMOOTH);
    }
  }

  private int[] weights(Layout.Split split, String place) {
    int[] kept = shares.get(place);
    if (kept != null && kept.length == split.parts().size()) {
      return kept;
    }
    double all = split.weights().stream().mapToDouble(w -> w).sum();
    return split.weights().stream().mapToInt(w -> (int) Math.max(1, Math.round(UNITS * w / all))).toArray();
  }

  private void keepShares() {
    sashes.forEach((place, form) -> shares.put(place, form.getWeights()));
  }
}
