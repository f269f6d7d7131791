package org.robotui.workbench.internal.model;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.install.SiteFeature;

/**
 * A feature that is installed, or offered by a site, or both.
 *
 * @param id of the feature
 * @param installed as it is installed
 * @param offered as the site has it
 */
public record FeatureRow(String id, Optional<SiteFeature> installed, Optional<SiteFeature> offered) {
  /** All that are installed and offered, by name. */
  public static List<FeatureRow> of(List<SiteFeature> installed, List<SiteFeature> offered) {
    Map<String, FeatureRow> rows = new TreeMap<>();
    installed.forEach(f -> rows.put(f.id(), new FeatureRow(f.id(), Optional.of(f), Optional.empty())));
    offered.forEach(f -> rows.merge(f.id(), new FeatureRow(f.id(), Optional.empty(), Optional.of(f)),
        (own, from) -> new FeatureRow(f.id(), own.installed(), from.offered())));
    List<FeatureRow> all = new ArrayList<>(rows.values());
    all.sort(Comparator.comparing(FeatureRow::name, String.CASE_INSENSITIVE_ORDER));
    return List.copyOf(all);
  }

  /** What it is called. */
  public String name() {
    return feature().name();
  }

  /** What it is for. */
  public String description() {
    return feature().description();
  }

  /** The installed version, empty where it is not installed. */
  public String installedVersion() {
    return installed.map(SiteFeature::version).orElse("");
  }

  /** The version of the site, empty where the site does not have it. */
  public String offeredVersion() {
    return offered.map(SiteFeature::version).orElse("");
  }

  /** Whether the site has it, and in another version than it is installed, if it is. */
  public boolean isNew() {
    return offered.isPresent() && !offeredVersion().equals(installedVersion());
  }

  private SiteFeature feature() {
    return offered.or(() -> installed).orElseThrow();
  }
}
