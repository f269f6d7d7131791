/**
 * What the messages of Player's interfaces look like. Small text files describe them; from those descriptions
 * {@link org.robotui.player.layout.Layouts} decodes any message into a record that can be browsed, and into the Java
 * records of {@code org.robotui.player.interfaces}.
 */
package org.robotui.player.layout;
