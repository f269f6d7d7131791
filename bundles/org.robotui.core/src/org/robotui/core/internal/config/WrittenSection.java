package org.robotui.core.internal.config;

import org.robotui.core.internal.config.model.RawSection;

/**
 * The settings of a component as they stand in the file.
 *
 * @param section keys and values with places
 */
record WrittenSection(YamlValue.Section section) implements RawSection {}
