package org.robotui.workbench.internal.pane;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.host.Ruic;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.dock.RobotArea;

/** Notes down what panes ask for. */
final class NoActions implements TopBar.Actions, Navigator.Actions, RobotArea.Actions {
  final List<String> calls = new ArrayList<>();

  @Override
  public void menu(String id, Control below) {
    calls.add("menu " + id);
  }

  @Override
  public void search() {
    calls.add("search");
  }

  @Override
  public void record(Control below) {
    calls.add("record");
  }

  @Override
  public void lease() {
    calls.add("lease");
  }

  @Override
  public void stop() {
    calls.add("stop");
  }

  @Override
  public void release() {
    calls.add("release");
  }

  @Override
  public void create() {
    // nothing
  }

  @Override
  public void addView() {
    calls.add("addView");
  }

  @Override
  public void open() {
    calls.add("open");
  }

  @Override
  public void select(String ruic) {
    calls.add("select " + ruic);
  }

  @Override
  public void unselect(String ruic) {
    calls.add("unselect " + ruic);
  }

  @Override
  public void restart(String ruic) {
    calls.add("restart " + ruic);
  }

  @Override
  public void remove(String ruic) {
    calls.add("remove " + ruic);
  }

  @Override
  public void settings(String ruic) {
    calls.add("settings " + ruic);
  }

  @Override
  public void exchange(String ruic) {
    calls.add("exchange " + ruic);
  }

  @Override
  public void portMenu(Control over, String ruic, SourceId port) {
    calls.add("menu of " + port + " of " + ruic);
  }

  @Override
  public void connections(String ruic) {
    calls.add("connections " + ruic);
  }

  @Override
  public void restart(Ruic ruic) {
    calls.add("restart " + ruic.name());
  }

  @Override
  public void reload() {
    calls.add("reload");
  }

  @Override
  public void closeProblems() {
    calls.add("closeProblems");
  }

  @Override
  public Optional<Control> welcome(Composite parent, Theme theme) {
    return Optional.empty();
  }
}
