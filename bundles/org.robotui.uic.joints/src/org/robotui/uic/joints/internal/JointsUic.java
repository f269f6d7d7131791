package org.robotui.uic.joints.internal;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.port.Input;
import org.robotui.data.joint.JointState;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewKey;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.joints.internal.model.JointTracks;
import org.robotui.uic.joints.internal.model.JointsLook;
import org.robotui.uic.joints.internal.view.JointsSurface;

/** The view: the tick takes what came and sorts, the surface lists. */
final class JointsUic extends SurfaceUic<JointsSurface> {
  private final UicContext context;
  private final Input<JointState> input;
  private final Input<JointState> messages;
  private final SettingsStore settings;
  private final JointTracks tracks;
  private final AtomicBoolean forget = new AtomicBoolean();
  private volatile JointsLook look;

  JointsUic(Input<JointState> input, Input<JointState> messages, UicContext context) {
    this.context = context;
    this.input = input;
    this.messages = messages;
    this.settings = context.settings();
    this.tracks = new JointTracks(context.clock()::agingNanos);
    this.look = look(System.nanoTime());
    offers()
        .add(new ViewAction("degrees", "Angles in degrees", "", Optional.of(this::degrees), () -> degrees(!degrees())))
        .add("forget", "Forget ranges and silent joints", Icon.RESTART, () -> forget.set(true))
        .action("yaml", "Copy as YAML", Icon.COPY, JointsSurface::copyYaml)
        .action("csv", "Copy as CSV", Icon.TEXT, JointsSurface::copyCsv);
  }

  @Override
  public boolean tick(long nowNanos) {
    tracks.take(input, messages, context.clock().agingNanos(nowNanos));
    if (forget.compareAndSet(true, false)) {
      tracks.forget();
    }
    JointsLook next = look(nowNanos);
    boolean changed = !next.equals(look);
    look = next;
    surface().ifPresent(s -> s.prepare(next));
    return changed;
  }

  private JointsLook look(long nowNanos) {
    return tracks.look(input, OptionsReader.read(settings.current()), context.clock().agingNanos(nowNanos));
  }

  @Override
  protected JointsSurface open(Composite parent, UiContext ui) {
    JointsSurface made = new JointsSurface(parent, ui, context.ruic().name(),
        new SubjectMenu(context, ui.theme()));
    made.prepare(look);
    return made;
  }

  @Override
  protected void refresh(JointsSurface shown) {
    shown.refresh();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Ctrl+1 \u2026 Ctrl+7", "Sort by a column"),
        new ViewKey("Ctrl+F, /", "Filter"),
        new ViewKey("Ctrl+C", "Copy the selected rows"));
  }

  private boolean degrees() {
    return settings.current().flag(JointsType.DEGREES);
  }

  /** Seen at once, also where no more data comes. */
  private void degrees(boolean wanted) {
    settings.set(JointsType.DEGREES, wanted);
    JointsLook next = look.inDegrees(wanted);
    look = next;
    surface().ifPresent(s -> s.prepare(next));
    refresh();
  }
}
