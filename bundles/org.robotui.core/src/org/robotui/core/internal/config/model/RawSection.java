package org.robotui.core.internal.config.model;

/**
 * Written values of one component with their places in the file, not checked yet: its type, and with it the schema, may
 * only appear later. Opaque to all but the reader and {@link SettingsCheck}.
 */
public interface RawSection {}
