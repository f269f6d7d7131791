package org.robotui.workbench.internal.pane;

import java.util.List;

/** The menus of the top bar; their ids are those under which the platform and its plug-ins contribute. */
public final class Menus {
  /** All menus, left to right. */
  public static final List<TopBar.MenuTitle> ALL = List.of(
      new TopBar.MenuTitle("file", "File"),
      new TopBar.MenuTitle("view", "View"),
      new TopBar.MenuTitle("perspective", "Perspective"),
      new TopBar.MenuTitle("robot", "Robot"),
      new TopBar.MenuTitle("window", "Window"),
      new TopBar.MenuTitle("help", "Help"));

  private Menus() {}
}
