package org.robotui.install;

/**
 * A feature: what users install as a unit.
 *
 * @param id its id, such as {@code org.robotui.feature.ros}
 * @param version its version, in the syntax of OSGi
 * @param name what it is called
 * @param description what it is for, may be empty
 */
public record SiteFeature(String id, String version, String name, String description) {
  /**
   * The feature in a sentence.
   *
   * @return name and version
   */
  public String label() {
    return name + " " + version;
  }
}
