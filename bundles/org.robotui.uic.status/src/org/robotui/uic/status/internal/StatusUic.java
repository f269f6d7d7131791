package org.robotui.uic.status.internal;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.data.sensor.Battery;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.show.SubjectMenu;

/** The view: the tick looks and makes the lines, the surface shows them. */
final class StatusUic extends SurfaceUic<StatusSurface> {
  private final UicContext context;
  private final Input<Battery> batteries;
  private volatile String filter = "";
  private volatile Page page;
  private StatusViewState seen; // only on the tick's thread
  private String filtered = ""; // only on the tick's thread

  StatusUic(UicContext context) {
    this.context = context;
    this.batteries = context.input(StatusType.BATTERY);
    this.seen = look();
    this.page = seen.page(filter);
  }

  @Override
  public boolean tick(long nowNanos) {
    StatusViewState next = look();
    String words = filter;
    if (next.equals(seen) && words.equals(filtered)) {
      return false;
    }
    seen = next;
    filtered = words;
    Page made = next.page(words);
    boolean changed = !made.equals(page);
    page = made;
    return changed;
  }

  @Override
  protected StatusSurface open(Composite parent, UiContext ui) {
    return new StatusSurface(parent, ui, new Actions(), context.ruic().name(),
        new SubjectMenu(context, ui.theme()));
  }

  @Override
  protected void refresh(StatusSurface shown) {
    shown.show(page);
  }

  Page page() {
    return page;
  }

  /** Where there are several, each by its port; and whose that is where several robot interfaces have one. */
  private static String name(SourceId source, List<SourceId> sources) {
    boolean several = sources.stream().map(SourceId::component).distinct().count() > 1;
    return sources.size() < 2 ? "Battery" : several ? source.toString() : source.port();
  }

  private StatusViewState look() {
    double low = context.settings().current().number(StatusType.LOW_CHARGE);
    List<SourceId> sources = batteries.sources();
    List<StatusRow> rows = sources.stream()
        .map(source -> BatteryRows.of(source, name(source, sources), batteries.latest(source).map(Envelope::value),
            batteries.state(source), low))
        .toList();
    Optional<String> stopped = context.ruic().authorities().stream()
        .flatMap(authority -> authority.stoppedBy().stream()).map(Principal::label).findFirst();
    return new StatusViewState(context.ruic().snapshot(), rows, stopped,
        context.settings().current().flag(StatusType.CONNECTIONS));
  }

  /** What the user can do. Display thread. */
  final class Actions {
    void stop() {
      context.ruic().authorities().forEach(authority -> authority.stop(context.principal()));
      now();
    }

    void releaseStop() {
      for (Authority authority : context.ruic().authorities()) {
        authority.releaseStop(context.principal());
      }
      now();
    }

    /** Whom that concerns: the title bar of the window stops and releases others as well. */
    String robots() {
      List<String> names = context.ruic().authorities().stream().map(Authority::robot).toList();
      return names.size() == 1 ? names.getFirst() : names.size() + " robots";
    }

    void connections(boolean shown) {
      context.settings().set(StatusType.CONNECTIONS, shown);
      now();
    }

    /** Shows only what contains some words, from the next tick on. */
    void filter(String words) {
      filter = words;
    }

    private void now() {
      page = look().page(filter);
      refresh();
    }
  }
}
