package org.robotui.api.host;

import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;

/**
 * Settings that stand together in a configuration file, or could.
 *
 * @param part what they are of
 * @param ruic the name of the robot UI
 * @param id of the interface or the view, or the name of the robot; else empty
 * @param title what users read
 * @param type id of the type of the robot UI, the interface or the view; else empty
 * @param file in which they stand
 * @param path the words that lead there in the file
 * @param line from 1: of what stands there already, else of what is around it
 * @param schema what can be set
 * @param values what the file says, by name: Boolean, String, List or Map
 * @param reading tells the text of the file apart from a later one
 */
public record SettingsGroup(Part part, String ruic, String id, String title, String type, Path file, List<String> path,
    int line, Schema schema, Map<String, Object> values, String reading) {
  /** What settings are of. */
  public enum Part {
    /** Of the robot UI itself and its type; after a restart of the robot UI. */
    RUIC,
    /** Of a robot interface; taken up by {@link Ruic#exchange}. */
    INTERFACE,
    /** Of a view; after a restart of the robot UI. */
    VIEW,
    /** Which port goes where; taken up at once. */
    CONNECTIONS,
    /** How a robot is kept safe; taken up at once. */
    SAFETY,
    /** Of the whole file: what is carried between its robots; taken up at once. Its robot UI has no name. */
    BRIDGES
  }

  /**
   * Copies the collections.
   *
   * @param part what they are of
   * @param ruic the name of the robot UI
   * @param id of the interface or the view, or the name of the robot
   * @param title what users read
   * @param type id of the type
   * @param file in which they stand
   * @param path the words that lead there
   * @param line from 1
   * @param schema what can be set
   * @param values what the file says
   * @param reading of the file
   */
  public SettingsGroup {
    path = List.copyOf(path);
    values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
  }

  /**
   * Which settings are others than the file says, also those that are absent in one of both.
   *
   * @param others values by name
   * @return the names of settings of the schema, in its order
   */
  public List<String> changed(Map<String, Object> others) {
    return schema.settings().stream().map(Setting::name).filter(n -> !isSame(values.get(n), others.get(n))).toList();
  }

  /**
   * Whether two values are written in the same way: maps have an order as well.
   *
   * @param one a value, or null for none
   * @param other another one
   * @return whether there is no difference
   */
  public static boolean isSame(Object one, Object other) {
    return Objects.equals(one, other) && Objects.toString(one).equals(Objects.toString(other));
  }
}
