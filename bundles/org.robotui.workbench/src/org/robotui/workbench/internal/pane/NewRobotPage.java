package org.robotui.workbench.internal.pane;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Label;
import org.robotui.api.host.CompositionState;
import org.robotui.api.host.CompositionState.Stage;
import org.robotui.api.host.Host;
import org.robotui.api.host.Installed;
import org.robotui.api.host.PortStatus;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.LinkLook;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.ChoiceField;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.PlainLabel;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowTable;
import org.robotui.ui.control.SettingsForm;
import org.robotui.workbench.internal.model.NewRobotModel;

/** The first step: which framework, where the robot is, and what it offers. Display thread only. */
final class NewRobotPage extends Composite {
  private static final int FORM = 380;
  private static final int FIELD_HEIGHT = 28;
  private static final int GAP = 10;

  private final Theme theme;
  private final NewRobotModel model;
  private final ChoiceField type;
  private final Label help;
  private final SettingsForm settings;
  private final QuietButton connect;
  private final RowTable<PortStatus> ports;
  private final Runnable changed;
  private List<PortStatus> shown = List.of();

  NewRobotPage(Composite parent, Theme theme, Host host, NewRobotModel model, Runnable changed) {
    super(parent, SWT.NONE);
    this.theme = theme;
    this.model = model;
    this.changed = changed;
    setBackground(theme.color(Role.PANEL));
    setLayout(layout(2, 0));
    Composite form = new Composite(this, SWT.NONE);
    form.setBackground(theme.color(Role.PANEL));
    GridLayout inner = layout(1, Theme.EDGE);
    inner.marginHeight = GAP;
    inner.verticalSpacing = Theme.STEP;
    form.setLayout(inner);
    GridData left = new GridData(SWT.FILL, SWT.FILL, false, true);
    left.widthHint = FORM;
    form.setLayoutData(left);
    heading(form, "FRAMEWORK");
    type = new ChoiceField(form, theme, "The framework", this::chooseType);
    GridData field = new GridData(SWT.FILL, SWT.TOP, true, false);
    field.heightHint = FIELD_HEIGHT;
    type.control().setLayoutData(field);
    help = new PlainLabel(form, SWT.WRAP, theme, Face.SMALL, Role.DIM);
    GridData words = new GridData(SWT.FILL, SWT.TOP, true, false);
    words.widthHint = FORM - 2 * Theme.EDGE;
    help.setLayoutData(words);
    heading(form, "SETTINGS");
    settings = new SettingsForm(form, theme, host::wrong);
    settings.control().setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    settings.onChange(this::typed);
    connect = new QuietButton(form, theme, this::connect).icon(Icon.LINK).text("Connect")
        .hint("Connect to the robot and show what it offers; nothing is sent to it").checked(true);
    connect.setLayoutData(new GridData(SWT.END, SWT.CENTER, false, false));
    ports = new RowTable<>(this, theme, List.of(
        Column.<PortStatus>words("Port", p -> p.port().port()).weight(1.3),
        Column.<PortStatus>words("Type", PortStatus::typeName).role(Role.DIM).weight(1),
        Column.<PortStatus>words("Way", NewRobotPage::way).role(Role.DIM).width(120).weight(0)),
        p -> p.kind() + " " + p.port());
    ports.list().named("What the robot offers");
    ports.control().setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    form();
  }

  private static String way(PortStatus port) {
    return switch (port.kind()) {
      case STREAM -> "sends";
      case COMMAND -> "takes";
      case CALL -> "answers";
      case BROWSE -> "tells";
    };
  }

  /** Whether everything that was typed can be tried. */
  boolean isFine() {
    return settings.problems().isEmpty();
  }

  /** Shows what was found so far. */
  void show(Optional<CompositionState> state) {
    boolean trying =
        state.map(CompositionState::stage).filter(s -> s == Stage.CONNECTING || s == Stage.LOOKING).isPresent();
    connect.setEnabled(isFine() && !trying);
    connect.text(state.isPresent() ? "Connect again" : "Connect").requestLayout();
    if (state.isEmpty()) {
      message(Health.NONE, "Not connected yet", "What the robot offers is shown here.");
    } else if (state.get().ports().isEmpty()) {
      Health health = trying ? Health.WAITING : state.get().stage() == Stage.FOUND ? Health.WARNING : Health.BAD;
      message(health, title(state.get().stage()),
          state.get().stage() == Stage.FAILED ? state.get().sentence() : LinkLook.text(state.get().link()));
    } else if (!state.get().ports().equals(shown)) {
      shown = state.get().ports();
      ports.list().noMessage();
      ports.show(shown);
    }
  }

  /** What is so, in a line: the reason is not said twice where it fills the page. */
  String sentence(CompositionState state) {
    return switch (state.stage()) {
      case UNREACHED -> "Not reached. Correct the settings or start the robot's software, and connect again.";
      case FAILED -> state.ports().isEmpty() ? "Correct the settings, and connect again." : state.sentence();
      case CONNECTING, LOOKING, FOUND, KNOWN -> state.sentence();
    };
  }

  private static String title(Stage stage) {
    return switch (stage) {
      case CONNECTING, LOOKING -> "Connecting";
      case FOUND -> "Nothing there";
      case KNOWN, UNREACHED -> "Not reached";
      case FAILED -> "Cannot be started";
    };
  }

  private void message(Health health, String title, String sentence) {
    shown = List.of();
    ports.show(List.of());
    ports.list().message(health, title, sentence);
  }

  private void form() {
    type.show(model.type().map(t -> t.descriptor().label()).orElse("none is installed"));
    help.setText(model.type().map(t -> t.descriptor().help()).orElse(""));
    settings.show(model.schema(), model.values());
    layout(true, true);
  }

  private void typed() {
    model.want(model.type().map(t -> t.descriptor().id()).orElse(""), settings.values());
    changed.run();
  }

  private void connect() {
    typed();
    if (isFine()) {
      model.connect();
      changed.run();
    } else {
      settings.showProblem();
    }
  }

  private void chooseType() {
    PopupMenu menu = new PopupMenu(type.control());
    for (Installed t : model.types()) {
      String id = t.descriptor().id();
      menu.radio(t.descriptor().label() + "  (" + id + ")", model.type().filter(t::equals).isPresent(), () -> {
        model.want(id, java.util.Map.of());
        form();
        changed.run();
      });
    }
    menu.openBelow(type.control());
  }

  @Override
  public boolean setFocus() {
    return !type.control().isDisposed() && type.control().setFocus();
  }

  private void heading(Composite parent, String words) {
    ShortenedLabel heading = new ShortenedLabel(parent, theme, Face.SMALL_STRONG, Role.DIM, words);
    GridData data = new GridData(SWT.FILL, SWT.TOP, true, false);
    data.verticalIndent = Theme.STEP;
    heading.setLayoutData(data);
  }

  private static GridLayout layout(int columns, int margin) {
    GridLayout layout = new GridLayout(columns, false);
    layout.marginWidth = margin;
    layout.marginHeight = margin;
    layout.horizontalSpacing = 2 * Theme.STEP;
    return layout;
  }
}
