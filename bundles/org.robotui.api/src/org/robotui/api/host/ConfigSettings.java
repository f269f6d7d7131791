package org.robotui.api.host;

import java.util.List;
import java.util.Map;
import org.robotui.api.config.Schema;

/**
 * What the configuration files that run can say of their robot UIs, setting by setting, and changes of that in the
 * files. What is written is noticed as any other change of a file, see {@link HostListener#configurationChanged}. Reads
 * and writes files, so not on the display thread; safe for all threads.
 */
public interface ConfigSettings {
  /**
   * All that can be set, as the files say it now. A file with an error lists only its robot UIs without one.
   *
   * @return in the order of the files; within a robot UI itself first, then interfaces, views, connections and the
   * safety of its robots
   */
  List<SettingsGroup> groups();

  /**
   * Writes those values into the file that differ from the group's; all else in the file stays as it is, with its
   * comments. What would be an error is not written, nor is anything into a file that has changed since the group was
   * read.
   *
   * @param group as it was listed
   * @param values by name, Boolean, Number, String, List or Map; those that are absent are taken out of the file, so
   * that the usual ones hold
   * @return what came of it
   */
  SettingsOutcome write(SettingsGroup group, Map<String, Object> values);

  /**
   * What can be said of a part beside the settings of its type, whichever the type is, such as the title of a view.
   *
   * @param part which
   * @return the settings that are always there; none for connections, whose names are those of ports
   */
  Schema always(SettingsGroup.Part part);
}
