/** A view that works. */
package org.robotui.workbench.tests.healthy;
