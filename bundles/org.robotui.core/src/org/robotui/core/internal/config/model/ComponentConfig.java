package org.robotui.core.internal.config.model;

/**
 * One component as written.
 *
 * @param id unique within the RUIC, robot interfaces and views together
 * @param type id of its type; empty for a view that the RUIC's type brings along and the file only configures
 * @param title what users call it, empty where not written
 * @param robot the robot that a robot interface speaks to: as written, else the name of the RUIC; empty for views
 * @param raw its settings
 * @param file as the user named it
 * @param line from 1, of its id
 * @param column from 1
 */
public record ComponentConfig(
    String id, String type, String title, String robot, RawSection raw, String file, int line, int column) {
  /**
   * The same with a type.
   *
   * @param id of the type
   * @return a copy
   */
  public ComponentConfig withType(String id) {
    return new ComponentConfig(this.id, id, title, robot, raw, file, line, column);
  }

  /**
   * Where it stands, for messages.
   *
   * @return file and line
   */
  public String place() {
    return file + ":" + line;
  }
}
