package org.robotui.uic.parameters.internal.view;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StackLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.DetailSplit;
import org.robotui.ui.control.MessagePane;
import org.robotui.ui.control.RowTable;
import org.robotui.uic.parameters.internal.model.Key;
import org.robotui.uic.parameters.internal.model.Panel;
import org.robotui.uic.parameters.internal.model.ParametersModel;
import org.robotui.uic.parameters.internal.model.ParametersViewState;

/** The programs whose settings can be changed while they run, and the form of the chosen one. Display thread. */
final class TunerPane {
  private static final int BESIDE_FROM = 560;
  private static final int LIST_SHARE = 30;

  private final ParametersModel model;
  private final DetailSplit split;
  private final RowTable<Key> servers;
  private final Composite stack;
  private final StackLayout leaves = new StackLayout();
  private final MessagePane message;
  private final TunerForm form;

  TunerPane(Composite parent, Theme theme, ParametersModel model, Runnable find) {
    this.model = model;
    split = new DetailSplit(parent, theme, LIST_SHARE).besideFrom(BESIDE_FROM, LIST_SHARE);
    servers =
        new RowTable<>(split.parts(), theme, List.of(Column.<Key>words("Program", Key::name).hint(Key::name)),
            key -> key);
    servers.list().named("Programs").onFind(find)
        .onSelect(keys -> keys.stream().findFirst().ifPresent(key -> model.tune(Optional.of(key))));
    stack = new Composite(split.parts(), SWT.NONE);
    stack.setBackground(theme.color(Role.PANEL));
    stack.setLayout(leaves);
    message = new MessagePane(stack, theme);
    form = new TunerForm(stack, theme);
    leaves.topControl = message.control();
  }

  Control control() {
    return split.parts();
  }

  RowTable<Key> servers() {
    return servers;
  }

  TunerForm form() {
    return form;
  }

  void show(ParametersViewState look) {
    List<Key> fitting = look.servers().stream().filter(key -> contains(key, look.filter())).toList();
    if (!fitting.equals(servers.list().rows())) {
      servers.show(fitting);
    }
    look.panel().ifPresent(panel -> mark(panel.server()));
    programs(look, fitting);
    settings(look);
  }

  private void programs(ParametersViewState look, List<Key> fitting) {
    if (!StateView.showsContent(look.state())) {
      servers.list().message(StateView.health(look.state()), "No programs", look.state().explanation());
    } else if (look.servers().isEmpty()) {
      servers.list().message(Health.NONE, "Nothing to tune",
          "No program of the robot lets its settings be changed while it runs.");
    } else if (fitting.isEmpty()) {
      servers.list().message(Health.NONE, "No match", "Esc clears the filter.");
    } else {
      servers.list().noMessage();
    }
    // Where there is nothing to choose, the room is not halved.
    split.detail(!look.servers().isEmpty());
  }

  private void settings(ParametersViewState look) {
    Optional<Panel> panel = look.panel();
    boolean usable =
        panel.isPresent() && panel.get().known() && !panel.get().knobs().isEmpty() && panel.get().failure().isEmpty();
    if (panel.isEmpty()) {
      message.show(Health.NONE, "No program is chosen", "Choose one to see and change its settings.");
    } else if (panel.get().failure().isPresent()) {
      message.show(Health.BAD, "No answer", panel.get().failure().get());
    } else if (!panel.get().known()) {
      message.show(Health.WAITING, "Asking " + panel.get().server().name(), "");
    } else if (!usable) {
      message.show(Health.NONE, "No settings", panel.get().server().name() + " has none.");
    } else {
      model.tuner().ifPresent(tuner -> form.show(tuner, panel.get()));
    }
    Control top = usable ? form.control() : message.control();
    if (leaves.topControl != top) {
      leaves.topControl = top;
      stack.layout();
    }
  }

  private void mark(Key server) {
    if (!servers.list().selected().contains(server)) {
      servers.list().select(server);
    }
  }

  private static boolean contains(Key key, String filter) {
    for (String word : filter.strip().toLowerCase(Locale.ROOT).split("\\s+")) {
      if (!key.name().toLowerCase(Locale.ROOT).contains(word)) {
        return false;
      }
    }
    return true;
  }
}
