package org.robotui.workbench.internal.dock;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Listener;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.show.Subject;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewItem;

/**
 * The views of one RUIC as they are arranged: in this part of its main window, and in windows of their own, which come
 * and go with it. Display thread only.
 */
public final class RuicSurface extends Composite {
  private final Ruic ruic;
  private final Docking docking;
  private final DockWindows windows;
  private Optional<ViewStack> last = Optional.empty();

  /**
   * Makes the controls of all views that are seen.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param ruic whose views
   * @param history how its views were arranged before; outlives the surface
   * @param addView has the user choose a view to add
   */
  public RuicSurface(Composite parent, Theme theme, Ruic ruic, ArrangeHistory history, Runnable addView) {
    super(parent, SWT.NONE);
    this.ruic = ruic;
    setBackground(theme.color(Role.PANEL));
    setLayout(new FillLayout());
    docking = new Docking(ruic.arranging(), history, this::arranged);
    windows = new DockWindows(this, theme, ruic, docking, addView);
    windows.show(docking.now());
    markFocus();
  }

  /** The RUIC that it shows. */
  public Ruic ruic() {
    return ruic;
  }

  /** What the user does to the arrangement. */
  public Docking docking() {
    return docking;
  }

  /** Has views stay where they lie, or lets users arrange them again. */
  public void lock(boolean now) {
    windows.lock(now);
  }

  /** Lays the views out as they are arranged now; those that go on stay as they are. */
  public void arranged() {
    if (!isDisposed()) {
      Optional<String> focused = focused().map(ViewEntry::id);
      if (windows.show(docking.now())) {
        focused.ifPresent(windows::focus);
      }
    }
  }

  /** Shows the instances that run now; called when the RUIC changed. */
  public void showInstances(RuicSnapshot now) {
    stacks().forEach(s -> s.showInstances(now));
  }

  /** All its open views, in the order of the arrangement. */
  public List<ViewEntry> views() {
    List<ComponentStatus> components = ruic.snapshot().components();
    List<String> failed =
        components.stream().filter(c -> c.state() == RuicState.FAILED).map(ComponentStatus::id).toList();
    return stacks().flatMap(s -> s.holders()
        .map(h -> new ViewEntry(h.id(), type(components, h.id()), ruic.title(h.id()), failed.contains(h.id()),
            s.isSeen(h), h.actions(), h.keys())))
        .toList();
  }

  /** What its views list and users look for by name; choosing one brings its view to the front first. */
  public List<ViewItem> items() {
    return stacks().flatMap(ViewStack::holders).flatMap(h -> h.items().stream().map(item -> inFront(h.id(), item)))
        .toList();
  }

  private ViewItem inFront(String id, ViewItem item) {
    return new ViewItem(item.kind(), item.name(), item.detail(), () -> {
      reveal(id);
      item.show().run();
    });
  }

  private static String type(List<ComponentStatus> components, String id) {
    return components.stream().filter(c -> c.kind() == ComponentStatus.Kind.UIC && c.id().equals(id)).findFirst()
        .map(ComponentStatus::type).orElse("");
  }

  /** Brings a view to the front of its tabs and gives it the keys. */
  public void reveal(String uic) {
    windows.reveal(uic);
  }

  /** The view that has the keys. */
  public Optional<ViewEntry> focused() {
    return seenIn(stacks().filter(ViewStack::holdsFocus).findFirst());
  }

  /** The view that had the keys last: a menu in which something is chosen for it has taken them. */
  public Optional<ViewEntry> lastFocused() {
    return seenIn(last.filter(stack -> !stack.isDisposed()));
  }

  /** The same with its control; none where it says why there is no view. */
  public Optional<SeenView> lastSeen() {
    return last.filter(stack -> !stack.isDisposed()).flatMap(ViewStack::seenView);
  }

  private Optional<ViewEntry> seenIn(Optional<ViewStack> stack) {
    Optional<String> id = stack.map(ViewStack::seenId);
    return views().stream().filter(v -> id.filter(v.id()::equals).isPresent()).findFirst();
  }

  /** Has the view that has, or had, the keys take the whole of its window, or its place again. */
  public void maximize() {
    stacks().filter(ViewStack::holdsFocus).findFirst().or(() -> last.filter(stack -> !stack.isDisposed()))
        .ifPresent(windows::maximize);
  }

  /** Has a view show what its last ticks prepared. */
  public void refresh(String uic) {
    stacks().forEach(s -> s.refresh(uic));
  }

  /** Brings a view to the front and has it show something that the user pointed at. */
  public void view(String uic, String showing, Subject subject) {
    reveal(uic);
    stacks().forEach(s -> s.view(uic, showing, subject));
  }

  /** Takes the view out whose code took part in a failure on the display thread; false where no view did. */
  public boolean blame(Throwable failure) {
    // One view's control may be laid out or painted from within another's code: the nearest one failed.
    Optional<ViewHolder> guilty = stacks().flatMap(ViewStack::holders).filter(h -> h.guilt(failure).isPresent())
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
    return stacks().filter(s -> !s.isDisposed()).findFirst().map(ViewStack::setFocus).orElseGet(super::setFocus);
  }

  private Stream<ViewStack> stacks() {
    return windows.stacks();
  }

  /** The line above the view that has the keys says so. */
  private void markFocus() {
    Listener mark = e -> stacks().filter(Predicate.not(ViewStack::isDisposed)).forEach(stack -> {
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
}
