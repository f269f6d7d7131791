package org.robotui.core.tests;

/**
 * Where an uninstalled bundle came from.
 *
 * @param name its symbolic name
 * @param location as it was installed with
 * @param jar its content
 */
record Installed(String name, String location, byte[] jar) {}
