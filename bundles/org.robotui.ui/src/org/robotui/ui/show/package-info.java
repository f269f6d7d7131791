/**
 * What views offer at the ports, frames and nodes that they list: one menu for all, dragging and dropping, a window
 * that says what a type is made of, and values as text. Which views show what is said by {@link org.robotui.api.show}.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.ui.show;
