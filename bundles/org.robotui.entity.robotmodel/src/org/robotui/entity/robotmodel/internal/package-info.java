/**
 * The display of robot models: it loads them in the background, and moves their links by transforms or by joint states.
 */
package org.robotui.entity.robotmodel.internal;
